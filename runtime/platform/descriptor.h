#pragma once

#include <chrono>
#include <cstdint>
#include <sys/epoll.h>
#include <sys/timerfd.h>
#include <unistd.h>
#include <utility>

namespace proskill::runtime {

/// File descriptor, closed by the destructor.
class Descriptor {
public:
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(Descriptor&& other) noexcept : number(std::exchange(other.number, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  [[nodiscard]] int get() const { return number; }

private:
  int number;
};

/// One-shot timer on the monotonic clock.
class Timer {
public:
  Timer() : descriptor(timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK)) {}
  /// \param delay 0: never
  void set(std::chrono::nanoseconds delay) {
    constexpr std::int64_t kUnit = 1'000'000'000;
    itimerspec time{};
    time.it_value = {delay.count() / kUnit, delay.count() % kUnit};
    timerfd_settime(descriptor.get(), 0, &time, nullptr);
  }
  /// Whether it has expired since it was last set or asked.
  [[nodiscard]] bool wentOff() {
    std::uint64_t times = 0;
    return ::read(descriptor.get(), &times, sizeof times) > 0;
  }
  [[nodiscard]] int get() const { return descriptor.get(); }

private:
  Descriptor descriptor;
};

/// Several descriptors as one, which is readable when any of them is.
class Watch {
public:
  Watch() : descriptor(epoll_create1(EPOLL_CLOEXEC)) {}
  void add(int watched, std::uint32_t events = EPOLLIN) { control(EPOLL_CTL_ADD, watched, events); }
  void change(int watched, std::uint32_t events) { control(EPOLL_CTL_MOD, watched, events); }
  void remove(int watched) { control(EPOLL_CTL_DEL, watched, 0); }
  [[nodiscard]] int get() const { return descriptor.get(); }

private:
  void control(int what, int watched, std::uint32_t events) {
    epoll_event event{};
    event.events = events;
    event.data.fd = watched;
    epoll_ctl(descriptor.get(), what, watched, &event);
  }

  Descriptor descriptor;
};

} // namespace proskill::runtime
