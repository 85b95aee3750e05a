#include <cstdint>

/// GCC calls a function at each edge; libFuzzer expects counters, as Clang inserts them. The tree
/// needs a newer C++ than the Clang of Debian 12's libFuzzer supports, so this file counts. Two
/// edges rarely share a counter, and then the fuzzer is only slightly less precise.
namespace {

constexpr std::uintptr_t kCounters = std::uintptr_t{1} << 18;
std::uint8_t counters[kCounters];

} // namespace

// the sanitizers and the linker (`--wrap`) define these names
extern "C" {

/// Load address of the program, so that one seed gives nearly the same run.
extern const char __executable_start;

void __sanitizer_cov_8bit_counters_init(std::uint8_t* begin, std::uint8_t* end);

/// GCC reports comparisons of floating-point numbers; libFuzzer does not support them.
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
