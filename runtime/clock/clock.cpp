#include "runtime/clock/clock.h"

#include <algorithm>
#include <cmath>
#include <poll.h>
#include <time.h>

namespace proskill::runtime {

namespace {

class SimulatedClock final : public Clock {
public:
  void start() override { date = 0; }
  Nanoseconds now() override { return date; }
  void wait(std::optional<Nanoseconds> until, const std::vector<int>& descriptors) override {
    static_cast<void>(descriptors);
    if (until) date = std::max(date, *until);
  }
  [[nodiscard]] bool isReal() const override { return false; }

private:
  Nanoseconds date = 0;
};

Nanoseconds machineTime() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * kSecond + time.tv_nsec;
}

class RealClock final : public Clock {
public:
  explicit RealClock(double times) : factor(times) {}

  void start() override { begin = machineTime(); }

  Nanoseconds now() override {
    const auto passed = machineTime() - begin;
    if (factor == 1) return passed;
    return static_cast<Nanoseconds>(std::floor(static_cast<double>(passed) * factor));
  }

  void wait(std::optional<Nanoseconds> date, const std::vector<int>& descriptors) override {
    watched.clear();
    for (const int descriptor : descriptors) watched.push_back({descriptor, POLLIN, 0});
    if (!date) {
      ppoll(watched.data(), watched.size(), nullptr, nullptr);
      return;
    }
    const auto rest = *date - now();
    if (rest <= 0) return;
    const auto real = factor == 1
                          ? rest
                          : static_cast<Nanoseconds>(std::ceil(static_cast<double>(rest) / factor));
    const timespec time{.tv_sec = real / kSecond, .tv_nsec = real % kSecond};
    ppoll(watched.data(), watched.size(), &time, nullptr);
  }

  [[nodiscard]] bool isReal() const override { return true; }

private:
  double factor;
  Nanoseconds begin = 0;
  std::vector<pollfd> watched; ///< a member, to avoid allocations
};

} // namespace

std::unique_ptr<Clock> simulatedClock() { return std::make_unique<SimulatedClock>(); }
std::unique_ptr<Clock> realClock(double factor) { return std::make_unique<RealClock>(factor); }

} // namespace proskill::runtime
