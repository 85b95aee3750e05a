#pragma once

#include "runtime/clock/clock.h"

#include <memory>
#include <string>
#include <string_view>

namespace proskill::cli {

/// The service manager that has started this process, if it wants to be notified: systemd, by the
/// protocol of sd_notify(3). A message that cannot be sent is dropped.
class ServiceManager {
public:
  /// Reads NOTIFY_SOCKET, WATCHDOG_USEC and WATCHDOG_PID.
  [[nodiscard]] static ServiceManager ofEnvironment();
  ServiceManager(ServiceManager&& other) noexcept;
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;
  ~ServiceManager();

  /// \param state such as `READY=1`
  void tell(std::string_view state) const;
  /// The time within which the manager wants to hear of this process; nullopt: it does not.
  [[nodiscard]] std::optional<runtime::Nanoseconds> watchdog() const { return limit; }

private:
  ServiceManager() = default;

  int socket = -1; ///< -1: nobody wants to know
  std::optional<runtime::Nanoseconds> limit;
};

/// A clock that notifies the service manager twice within each of its limits, when its owner waits.
/// So a run that hangs is noticed. The same clock if there is no limit.
/// \param speed of the clock \pre the manager outlives it
[[nodiscard]] std::unique_ptr<runtime::Clock>
watchedClock(std::unique_ptr<runtime::Clock> clock, const ServiceManager& manager, double speed);

/// Locks the memory of this process, and asks for the scheduler's real-time class for this thread.
/// Threads and programs that it starts do not inherit the class.
/// \return what was refused, with the reason; empty: nothing
[[nodiscard]] std::string becomeRealtime();

} // namespace proskill::cli
