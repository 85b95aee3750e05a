#pragma once

#include "runtime/machine/machine.h"
#include "runtime/platform/platform.h"

#include <string>

namespace proskill::runtime {

enum class RemarkKind : std::uint8_t {
  Started,     ///< the platform was asked to perform an action
  Asked,       ///< an action was asked to stop
  GuardFailed, ///< an invariant was violated, and its skill ends
  Note,        ///< a remark without effect on the run
  Holds,       ///< one of the program's properties is true, however the run goes on
  // Faults:
  Undershoot, ///< it took less time than its interval allows
  Overshoot,  ///< it takes more time than its interval allows
  Alarm,      ///< a step has an origin in codegen::Model::alarms
  Fault,      ///< the platform violates the protocol
  Violated,   ///< one of the program's properties is false, however the run goes on
};

/// A remark on the run, which is not a step.
struct Remark {
  RemarkKind kind = RemarkKind::Note;
  Nanoseconds date = 0;
  std::string_view subject; ///< a skill, an event or a property; empty: the run
  std::string_view text;
  fiacre::OriginId origin = 0;  ///< its place in the program, if any
  const Start* start = nullptr; ///< Started: the action and its arguments
};

[[nodiscard]] inline bool isBad(RemarkKind kind) { return kind >= RemarkKind::Undershoot; }

/// Observes a run while it happens.
class Observer {
public:
  virtual ~Observer() = default;
  /// \param lag time between the step's date and when it was taken
  virtual void onStep(const Machine& machine, verify::TransitionId step, Nanoseconds date,
                      Nanoseconds lag) = 0;
  virtual void onRemark(const Remark& remark) = 0;
};

} // namespace proskill::runtime
