#pragma once

#include "runtime/conform/recorded_run.h"
#include "verify/trace/simulator.h"

#include <map>
#include <memory>

namespace proskill::runtime {

/// The verified model, prepared for following recorded runs. Dates are in nanoseconds. With a
/// tolerance, an action that is asked to stop takes time, as in the executed edition.
struct ConformanceModel {
  codegen::Model model;
  verify::System system;
  std::vector<fiacre::Interval> promised; ///< by transition: its interval without the tolerance
  std::vector<bool> isHidden;             ///< by transition: recordings do not contain it
  std::vector<bool> isOfAction;           ///< by transition: the result of an action
  std::vector<bool> isOfEvent;            ///< by transition: an event with `:every`
  bool environmentIsHidden = false;
  /// Transitions that may have an origin, by the origin's key.
  std::map<std::string, std::vector<verify::TransitionId>> byOrigin;

  [[nodiscard]] const std::vector<verify::TransitionId>& candidates(const RecordedStep& step) const;
};

/// \param executed the program in executable form
/// \param tolerance by which the intervals of actions are widened, and how long they may take to
/// stop
[[nodiscard]] std::expected<std::unique_ptr<const ConformanceModel>, NotExecutable>
conformanceModel(const analysis::Program& program, const Executable& executed,
                 const std::string& mainSkill, bool environment, Nanoseconds tolerance);

/// Key of an origin: origins with the same actor and description share it.
[[nodiscard]] std::string keyOf(const fiacre::Origin& origin);

} // namespace proskill::runtime
