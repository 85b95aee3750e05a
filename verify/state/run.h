#pragma once

#include "verify/model/system.h"

#include <string>

namespace proskill::verify {

enum class Outcome : std::uint8_t {
  Done,
  GaveUp, ///< an `on` was false: the transition is not enabled
  Failed, ///< a value left its range or cannot be had: an error of the model
};

/// What happened in a step. Kept between steps, so that nothing is allocated.
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

/// Is told what a step looks at and writes, in order.
class StepListener {
public:
  StepListener() = default;
  StepListener(const StepListener&) = delete;
  StepListener& operator=(const StepListener&) = delete;
  virtual ~StepListener() = default;
  /// The next part sees the state before the step, whatever others wrote.
  virtual void beginApart() = 0;
  /// \param target what gets the value; kNone: it decides how the step goes on
  virtual void evaluates(NodeId node, const Word* state, CellId target) = 0;
  virtual void writes(CellId cell) = 0;
};

/// Fires a transition in place, whatever its guard. Where the outcome is not Done, the state is
/// spoilt. \pre the guard holds
[[nodiscard]] Outcome fire(const System& system, TransitionId transition, Word* state,
                           StepLog& log);
/// The same, told to a listener, except for what observers see.
[[nodiscard]] Outcome fire(const System& system, TransitionId transition, Word* state, StepLog& log,
                           StepListener& listener);

/// Whether the transition can fire, were it not for time.
[[nodiscard]] bool isEnabled(const System& system, TransitionId transition, const Word* state);

/// Whether firing a transition restarts the time of another: it moves an instance that takes part
/// in the other.
[[nodiscard]] bool disturbs(const System& system, TransitionId fired, TransitionId other);

} // namespace proskill::verify
