#include "cli/commands/front_limits.h"

#include "verify/limits.h"

#include <algorithm>

namespace proskill::cli {

namespace {

using Clock = std::chrono::steady_clock;

/// What the front may take in any case.
constexpr double kLeastSeconds = 0.5;
constexpr std::uint64_t kLeastGrowth = std::uint64_t{32} << 20;

constexpr FrontLimitMet kTime{"the time limit was reached", "--time-limit"};
constexpr FrontLimitMet kMemory{"the memory limit was reached", "--memory-limit"};

class FrontWatch {
public:
  explicit FrontWatch(const FrontLimits& of)
      : limits(of), start(of.bytes ? verify::residentBytes() : 0) {}

  /// Asks the system at most once per millisecond.
  std::optional<FrontLimitMet> met() {
    const auto now = Clock::now();
    if (now < next) return std::nullopt;
    next = now + std::chrono::milliseconds(1);
    const std::chrono::duration<double> elapsed = now - limits.begun;
    if (limits.seconds && elapsed.count() >= std::max(*limits.seconds, kLeastSeconds)) return kTime;
    if (limits.bytes && verify::residentBytes() >= std::max(*limits.bytes, start + kLeastGrowth))
      return kMemory;
    return std::nullopt;
  }

private:
  const FrontLimits& limits;
  std::uint64_t start; ///< resident bytes
  Clock::time_point next;
};

} // namespace

std::optional<FrontLimitMet> withinLimits(const FrontLimits& limits,
                                          const std::function<void()>& work) {
  FrontWatch watch(limits);
  std::optional<FrontLimitMet> met;
  const analysis::StopWhen stop([&] { return (met = watch.met()).has_value(); });
  try {
    work();
    return std::nullopt;
  } catch (const analysis::Stopped&) {
    return met;
  }
}

} // namespace proskill::cli
