#pragma once

#include "runtime/conform/recorded_run.h"
#include "verify/trace/simulator.h"

#include <map>
#include <memory>

namespace proskill::runtime {

/// The model that is verified, as a recorded run is followed through it. Dates are in nanoseconds.
struct OfflineModel {
  codegen::Model model;
  verify::System system;
  std::vector<bool> isHidden;   ///< by transition: recordings do not have it
  std::vector<bool> isOfAction; ///< by transition: an action's result
  std::vector<bool> isOfEvent;  ///< by transition: an event that comes by itself
  bool environmentIsHidden = false;
  /// Transitions that may pass an origin, by its words.
  std::map<std::string, std::vector<verify::TransitionId>> byOrigin;

  [[nodiscard]] const std::vector<verify::TransitionId>& candidates(const RecordedStep& step) const;
};

/// \param tolerance by which the intervals of actions are widened
[[nodiscard]] std::expected<std::unique_ptr<const OfflineModel>, NotExecutable>
offlineModel(const analysis::Program& program, const std::string& mainSkill, bool environment,
             Nanoseconds tolerance);

/// The same for origins that say the same of the same actor.
[[nodiscard]] std::string keyOf(const fiacre::Origin& origin);

} // namespace proskill::runtime
