#include <cstdint>

/// GCC calls a function at each edge of what is fuzzed; libFuzzer wants counters, as Clang makes
/// them. The tree needs a newer C++ than the Clang whose libFuzzer Debian 12 has, so we count
/// ourselves. Two edges with one counter are rare, and only make the fuzzer a little more blind.
namespace {

constexpr std::uintptr_t kCounters = std::uintptr_t{1} << 18;
std::uint8_t counters[kCounters];

} // namespace

// The names are the sanitizers' and the linker's (`--wrap`).
extern "C" {

/// Where the program begins, wherever it was loaded: so that one seed gives nearly one run.
extern const char __executable_start;

void __sanitizer_cov_8bit_counters_init(std::uint8_t* begin, std::uint8_t* end);

/// Of numbers with a fraction GCC tells, and libFuzzer knows nothing.
void __sanitizer_cov_trace_cmpf(float /*left*/, float /*right*/) {}
void __sanitizer_cov_trace_cmpd(double /*left*/, double /*right*/) {}

void __wrap___sanitizer_cov_trace_pc() {
  const auto edge = reinterpret_cast<std::uintptr_t>(__builtin_return_address(0)) -
                    reinterpret_cast<std::uintptr_t>(&__executable_start);
  ++counters[(edge ^ (edge >> 18)) % kCounters];
}
}

namespace {

[[gnu::constructor]] void registerCounters() {
  __sanitizer_cov_8bit_counters_init(counters, counters + kCounters);
}

} // namespace
