#pragma once

#include "groot/statuses.h"
#include "runtime/control/bounded_queue.h"
#include "runtime/control/pause.h"
#include "runtime/machine/machine.h"

#include <atomic>
#include <memory>
#include <string>

namespace proskill::groot {

/// Where a run stops at a node, as BehaviorTree.CPP numbers it.
enum class Position : std::uint8_t {
  Pre = 0,  ///< when the run is at the node, and has not executed it
  Post = 1, ///< when the node has ended
};

/// A run has stopped at a node.
struct Stop {
  Uid uid = 0;
  Position position = Position::Pre;
  Status status = Status::Idle; ///< Post: how the node has ended
  bool isFirst = false;         ///< the run has gone on from all earlier ones
};

/// The nodes at which a run stops. Viewers set them in one thread, the run looks for them in its
/// own. Without any, a step costs the run an atomic read.
class Breakpoints {
public:
  /// \param mayStop null: the run cannot be paused, and never stops
  /// \pre the arguments outlive this
  Breakpoints(const Tree& tree, const runtime::Executable& executable, runtime::Pause* mayStop);

  // For the viewers
  [[nodiscard]] bool canStop() const { return pause != nullptr; }
  void set(Uid uid, Position position, bool isOn);
  /// Takes the next stop of the run. \return false if there is none
  bool takeStop(Stop& stop);
  /// Whether the run is still where it has stopped: nobody else has let it go on.
  [[nodiscard]] bool isHeld() const { return pause && pause->isHeld() && !wentOn; }
  /// Lets the run go on. \pre canStop()
  void release();

  // For the run
  /// Stops the run if a step has brought it to a breakpoint. Allocates no memory and takes no lock.
  void follow(const runtime::Machine& machine);

private:
  void noticeChange(Uid uid, Status status);
  void stopAt(Uid uid, Position position, Status status);

  runtime::Pause* const pause;
  std::unique_ptr<std::atomic<std::uint8_t>[]> on; ///< by uid: a bit for each position
  std::atomic<std::size_t> count{0};               ///< of the bits
  std::atomic<bool> wentOn{true};                  ///< since the last stop
  runtime::BoundedQueue<Stop> stops;
  bool isFollowing = false; ///< the run's: the statuses are those of its last state
  bool isLooking = false;   ///< the run's: changes of statuses are those of a step
  Statuses statuses;        ///< the run's
};

} // namespace proskill::groot
