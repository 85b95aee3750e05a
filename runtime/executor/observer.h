#pragma once

#include "runtime/machine/machine.h"
#include "runtime/platform/platform.h"

#include <string>

namespace proskill::runtime {

enum class RemarkKind : std::uint8_t {
  Started,     ///< an action was given to the platform
  Asked,       ///< an action was asked to stop
  GuardFailed, ///< an invariant was broken, and its skill ends with that
  Note,        ///< something that changes nothing
  // What should not be:
  Undershoot, ///< it took less than its interval says
  Overshoot,  ///< it takes more
  Alarm,      ///< a step passed one of codegen::Model::alarms
  Fault,      ///< the platform does not do what it should
};

/// Something that is to be told beside the steps.
struct Remark {
  RemarkKind kind = RemarkKind::Note;
  Nanoseconds date = 0;
  std::string_view subject; ///< a skill or an event; empty: the run
  std::string_view text;
  fiacre::OriginId origin = 0;  ///< its place in the program, where it has one
  const Start* start = nullptr; ///< Started
};

[[nodiscard]] inline bool isBad(RemarkKind kind) { return kind >= RemarkKind::Undershoot; }

/// Hears of a run what happens, when it happens.
class Observer {
public:
  virtual ~Observer() = default;
  /// \param lag how much later than its date the step was taken
  virtual void onStep(const Machine& machine, verify::TransitionId step, Nanoseconds date,
                      Nanoseconds lag) = 0;
  virtual void onRemark(const Remark& remark) = 0;
};

} // namespace proskill::runtime
