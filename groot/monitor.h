#pragma once

#include "groot/protocol.h"
#include "groot/zeromq.h"
#include "runtime/control/byte_queue.h"
#include "runtime/control/wake_up.h"
#include "runtime/executor/observer.h"

#include <atomic>
#include <thread>

namespace proskill::groot {

/// How viewers may influence a run.
struct Influence {
  runtime::Pause* pause = nullptr;                 ///< null: not at all
  std::string whyNot = "the run cannot be paused"; ///< if it is null
};

/// Shows a run to viewers. A step puts its state into a bounded queue, without a lock; a thread
/// takes the states out and answers requests. So viewers have no influence on the run but by
/// breakpoints, which pause it.
class Monitor {
public:
  /// \param waits whether the run waits where the queue is full, as it may in simulated time; else
  /// states are skipped
  /// \pre the executable and the pause outlive this, as this does its observer
  Monitor(Tree of, const runtime::Executable& executable, std::unique_ptr<Sockets> at, bool waits,
          Influence influence);
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;
  ~Monitor();

  [[nodiscard]] std::unique_ptr<runtime::Observer> observer();
  [[nodiscard]] std::uint16_t port() const { return sockets->port(); }

  /// The run's: adds a state.
  void push(const std::vector<verify::Word>& state);
  /// The run's: it has taken a step.
  void follow(const runtime::Machine& machine);

private:
  void serve();
  bool takeSome();
  [[nodiscard]] long longestWait() const;

  const Tree tree;
  const bool waits;
  const std::unique_ptr<Sockets> sockets;
  Breakpoints breakpoints;
  Hooks hooks;             ///< of the thread alone
  Protocol protocol;       ///< likewise
  std::uint32_t stops = 0; ///< likewise: number of messages
  runtime::ByteQueue<Moment> queue;
  bool isGap = false; ///< the run's: the last state has found no room
  runtime::WakeUp bell;
  std::atomic<bool> isAsleep{false};
  std::atomic<bool> isOver{false};
  std::thread thread; ///< the last member, since it uses the others
};

} // namespace proskill::groot
