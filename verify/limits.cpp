#include "verify/limits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include <fcntl.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <unistd.h>

namespace proskill::verify {

namespace {

/// Returns unused memory, so that an earlier verification in this process does not count.
void giveBackFreeMemory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace

LimitWatch::LimitWatch(const Options& of) : options(of), start(now()), reported(start) {
  if (options.limits.bytes) giveBackFreeMemory();
}

double LimitWatch::now() const {
  if (options.clock) return options.clock();
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

std::string LimitWatch::met(const Progress& progress, std::uint64_t growth) {
  constexpr double kBetweenReports = 0.25;
  if (options.progress && now() - reported >= kBetweenReports) {
    reported = now();
    options.progress(progress);
  }
  if (auto limit = passed(progress.bytes, growth); !limit.empty()) return limit;
  const auto& classes = options.limits.classes;
  return noted(classes && progress.classes >= *classes ? "the limit of classes was reached" : "");
}

std::string LimitWatch::noted(std::string limit) {
  if (!limit.empty()) last = limit;
  return limit;
}

void LimitWatch::look() {
  calls = 0;
  if (auto limit = passed(0, 0); !limit.empty()) throw LimitMet{std::move(limit)};
}

/// \param counted size of the tables in bytes, for systems that do not report the memory of a
/// process
std::string LimitWatch::passed(std::uint64_t counted, std::uint64_t growth) {
  const auto& limits = options.limits;
  if (options.cancelled && options.cancelled->load(std::memory_order_relaxed))
    return noted("cancelled");
  if (limits.seconds && now() - start >= *limits.seconds)
    return noted("the time limit was reached");
  if (limits.bytes && std::max(counted, resident(now())) + growth >= *limits.bytes)
    return noted(std::string(kMemoryLimitMet));
  return {};
}

/// Some of what is left is for what is not counted: expansions, indices of files, code that was not
/// used yet.
std::optional<std::uint64_t> LimitWatch::bytesForDiskSearch(std::string_view met) {
  if (!options.spill || met != kMemoryLimitMet || !options.limits.bytes) return std::nullopt;
  giveBackFreeMemory();
  measured = -1;
  constexpr std::uint64_t kMostOfOthers = std::uint64_t{3} << 20;
  const std::uint64_t used = resident(now());
  const std::uint64_t left = *options.limits.bytes - std::min(used, *options.limits.bytes);
  return (left - std::min(left / 2, kMostOfOthers)) / 4 * 3;
}

/// Asking the system takes some microseconds, so this does it at most once per millisecond.
std::uint64_t LimitWatch::resident(double moment) {
  constexpr double kBetweenMeasurements = 0.001;
  if (measured >= 0 && moment - measured < kBetweenMeasurements) return bytes;
  measured = moment;
  bytes = residentBytes();
  return bytes;
}

std::uint64_t residentBytes() {
  std::array<char, 128> text{};
  const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  const auto count = ::read(file, text.data(), text.size());
  ::close(file);
  if (count <= 0) return 0;
  std::string_view rest(text.data(), static_cast<std::size_t>(count));
  rest.remove_prefix(std::min(rest.find(' ') + 1, rest.size())); // the second number, in pages
  std::uint64_t pages = 0;
  std::from_chars(rest.data(), rest.data() + rest.size(), pages);
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

} // namespace proskill::verify
