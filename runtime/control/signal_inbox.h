#pragma once

#include "runtime/control/bounded_queue.h"
#include "runtime/control/wake_up.h"
#include "runtime/platform/platform.h"

#include <mutex>

namespace proskill::runtime {

/// Events and interrupts that people send to a run.
class SignalInbox {
public:
  /// \param run wakes the run; it outlives this
  explicit SignalInbox(WakeUp& run) : wakeUp(run), queue(kMost) {}

  /// From any thread. \param signal in codegen::Model::signals
  /// \return false if too many wait
  bool send(std::uint32_t signal);
  /// Number of those that the run has not taken yet.
  [[nodiscard]] std::size_t waiting() const { return queue.size(); }

  /// The run's: takes the next one.
  bool take(std::uint32_t& signal);

private:
  static constexpr std::size_t kMost = 64;
  WakeUp& wakeUp;
  std::mutex senders; ///< one at a time; the run takes no lock
  BoundedQueue<std::uint32_t> queue;
};

/// A platform that also reports what comes through an inbox, in the same way as its own signals.
/// \param waits whether a run in which nothing else can happen waits for them
/// \pre both outlive it
[[nodiscard]] std::unique_ptr<Platform> withInbox(Platform& inner, SignalInbox& inbox, bool waits);

} // namespace proskill::runtime
