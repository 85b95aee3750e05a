#include "cli/execution/service.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <sched.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace proskill::cli {

using runtime::Clock;
using runtime::Nanoseconds;

namespace {

constexpr int kPriority = 50; ///< below the kernel's own threads for interrupts
constexpr Nanoseconds kMicrosecond = 1'000;

std::optional<std::int64_t> numberIn(const char* variable) {
  const char* text = std::getenv(variable);
  if (!text) return std::nullopt;
  std::int64_t number = 0;
  const auto* end = text + std::strlen(text);
  const auto read = std::from_chars(text, end, number);
  if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
  return number;
}

/// Connects to a datagram socket; a leading `@` stands for the abstract name space. -1: it cannot.
int connectTo(std::string_view path) {
  sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
  if (path.empty() || path.size() >= sizeof address.sun_path) return -1;
  path.copy(address.sun_path, path.size());
  if (path.front() == '@') address.sun_path[0] = '\0';
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size());
  const int made = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const auto* to = static_cast<const sockaddr*>(static_cast<const void*>(&address));
  if (made >= 0 && ::connect(made, to, length) == 0) return made;
  if (made >= 0) ::close(made);
  return -1;
}

class WatchedClock final : public Clock {
public:
  WatchedClock(std::unique_ptr<Clock> of, const ServiceManager& to, Nanoseconds between)
      : inner(std::move(of)), manager(to), interval(between) {}

  void start() override {
    inner->start();
    last = 0;
  }
  Nanoseconds now() override { return inner->now(); }
  void wait(std::optional<Nanoseconds> date, const std::vector<int>& descriptors) override {
    notify();
    const auto next = last + interval;
    inner->wait(date ? std::min(*date, next) : next, descriptors);
    notify();
  }
  [[nodiscard]] bool isReal() const override { return inner->isReal(); }

private:
  void notify() {
    const auto date = inner->now();
    if (date < last + interval) return;
    last = date;
    manager.tell("WATCHDOG=1");
  }

  std::unique_ptr<Clock> inner;
  const ServiceManager& manager;
  Nanoseconds interval; ///< in the time of the clock
  Nanoseconds last = 0;
};

} // namespace

ServiceManager ServiceManager::ofEnvironment() {
  ServiceManager made;
  const char* path = std::getenv("NOTIFY_SOCKET");
  if (!path) return made;
  made.socket = connectTo(path);
  const auto time = numberIn("WATCHDOG_USEC");
  if (time && *time > 0 && numberIn("WATCHDOG_PID").value_or(getpid()) == getpid())
    made.limit = *time * kMicrosecond;
  return made;
}

ServiceManager::ServiceManager(ServiceManager&& other) noexcept
    : socket(std::exchange(other.socket, -1)), limit(other.limit) {}

ServiceManager::~ServiceManager() {
  if (socket >= 0) ::close(socket);
}

void ServiceManager::tell(std::string_view state) const {
  if (socket >= 0) std::ignore = ::send(socket, state.data(), state.size(), MSG_NOSIGNAL);
}

std::unique_ptr<Clock> watchedClock(std::unique_ptr<Clock> clock, const ServiceManager& manager,
                                    double speed) {
  if (!manager.watchdog()) return clock;
  const auto interval =
      static_cast<Nanoseconds>(static_cast<double>(*manager.watchdog()) / 2 * speed);
  return std::make_unique<WatchedClock>(std::move(clock), manager,
                                        std::max<Nanoseconds>(interval, 1));
}

std::string becomeRealtime() {
  const auto reason = [] { return std::generic_category().message(errno); };
  std::string refused;
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    refused += fmt::format("its memory cannot be locked: {}", reason());
  const sched_param parameters{.sched_priority = kPriority};
  if (sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &parameters) != 0)
    refused += fmt::format("{}SCHED_FIFO was refused: {}", refused.empty() ? "" : "; ", reason());
  return refused;
}

} // namespace proskill::cli
