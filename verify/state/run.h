#pragma once

#include "verify/model/system.h"

#include <string>

namespace proskill::verify {

enum class Outcome : std::uint8_t {
  Done,
  GaveUp, ///< an `on` was false, so the transition is not enabled
  Failed, ///< a value is out of range or undefined: an error of the model
};

/// What happened in a step. Reuse it for many steps, so that nothing is allocated.
struct StepLog {
  std::vector<EventId> events;
  std::vector<fiacre::OriginId> origins;
  std::vector<std::uint32_t> leaves; ///< by part
  std::string failure;

  void clear() {
    events.clear();
    origins.clear();
    leaves.clear();
  }
};

/// Receives what a step reads and writes, in order.
class StepListener {
public:
  StepListener() = default;
  StepListener(const StepListener&) = delete;
  StepListener& operator=(const StepListener&) = delete;
  virtual ~StepListener() = default;
  /// From here on the next part reads the state before the step, without the other parts' writes.
  virtual void beginApart() = 0;
  /// \param target the cell that gets the value; kNone: the value decides how the step continues
  virtual void evaluates(NodeId node, const Word* state, CellId target) = 0;
  virtual void writes(CellId cell) = 0;
};

/// Fires a transition in place without testing its guard. Unless the outcome is Done, the state is
/// undefined afterwards. \pre the guard holds
[[nodiscard]] Outcome fire(const System& system, TransitionId transition, Word* state,
                           StepLog& log);
/// The same without a log.
[[nodiscard]] Outcome fire(const System& system, TransitionId transition, Word* state);
/// The same as the first; also notifies a listener of everything but the conditions of observers.
[[nodiscard]] Outcome fire(const System& system, TransitionId transition, Word* state, StepLog& log,
                           StepListener& listener);

/// Whether the discrete state allows the transition; time is ignored.
[[nodiscard]] bool isEnabled(const System& system, TransitionId transition, const Word* state);

/// Whether firing a transition resets the clock of another: it moves an instance that takes part in
/// the other.
[[nodiscard]] bool disturbs(const System& system, TransitionId fired, TransitionId other);

} // namespace proskill::verify
