#include "runtime/clock/clock.h"

#include <algorithm>
#include <cmath>
#include <poll.h>
#include <sys/prctl.h>
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

  void start() override {
    // Otherwise the system may let every wait of this thread end 50 µs late.
    prctl(PR_SET_TIMERSLACK, 1);
    begin = machineTime();
  }

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

class TickingClock final : public Clock {
public:
  TickingClock(std::unique_ptr<Clock> of, Nanoseconds each) : inner(std::move(of)), period(each) {}

  void start() override { inner->start(); }
  Nanoseconds now() override { return inner->now() / period * period; }
  void wait(std::optional<Nanoseconds> date, const std::vector<int>& descriptors) override {
    if (date && *date <= now()) return;
    inner->wait(date ? std::optional((*date + period - 1) / period * period) : std::nullopt,
                descriptors);
    const auto reached = inner->now(); // a report may have come between ticks
    if (reached % period != 0) inner->wait((reached / period + 1) * period, {});
  }
  [[nodiscard]] bool isReal() const override { return inner->isReal(); }

private:
  std::unique_ptr<Clock> inner;
  Nanoseconds period;
};

} // namespace

std::unique_ptr<Clock> tickingClock(std::unique_ptr<Clock> inner, Nanoseconds period) {
  return std::make_unique<TickingClock>(std::move(inner), period);
}

std::unique_ptr<Clock> simulatedClock() { return std::make_unique<SimulatedClock>(); }
std::unique_ptr<Clock> realClock(double factor) { return std::make_unique<RealClock>(factor); }

} // namespace proskill::runtime
