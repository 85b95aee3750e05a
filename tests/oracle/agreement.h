#pragma once

#include "tests/support/oracle/region_graph.h"
#include "verify/verify.h"

#include <optional>
#include <string>
#include <vector>

namespace proskill::oracle {

/// How the engine may be set: all measures, none, and each one left out. By name.
[[nodiscard]] const std::vector<std::pair<std::string, verify::Options>>& settings();

/// What an exploration by the interpreter has to offer, where the model is small enough.
struct Judged {
  std::vector<std::optional<bool>>
      truths; ///< by property; nothing where the oracle does not know the pattern
  std::size_t nodes = 0;
  bool complete = false;
};
[[nodiscard]] Judged judge(const fiacre::Program& program, std::size_t limit,
                           Reading reading = Reading::Engine);

/// Asks the engine for every property under one setting, and says where it is not of the oracle's
/// mind, or where a trace of its cannot be replayed. A question that stays open is a disagreement,
/// but where zones are not extrapolated. \param decided counts those that were answered
[[nodiscard]] std::optional<std::string>
disagreement(const fiacre::Program& program, const fiacre::Provenance& provenance,
             const Judged& judged, const std::pair<std::string, verify::Options>& setting,
             std::size_t* decided = nullptr);

/// The program with a property for each state of each instance and for each tag, which the
/// properties do not ask for yet: is it never there?
[[nodiscard]] fiacre::Program askedForControl(fiacre::Program program);

} // namespace proskill::oracle
