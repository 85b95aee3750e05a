#pragma once

#include "tests/support/oracle/region_graph.h"
#include "verify/verify.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace proskill::oracle {

/// Settings of the engine: all reductions, none, and all but each one. By name.
[[nodiscard]] const std::vector<std::pair<std::string, verify::Options>>& settings();

/// Results of the interpreter's exploration, if the model is small enough.
struct Judged {
  std::vector<std::optional<bool>>
      truths; ///< by property; nullopt if the oracle does not know the pattern
  std::size_t nodes = 0;
  bool complete = false;
  std::shared_ptr<const Interpreter> model; ///< as the engine reads it: for all replays
};
/// \pre `program` outlives the result
[[nodiscard]] Judged judge(const fiacre::Program& program, std::size_t limit,
                           Reading reading = Reading::Engine);

/// Asks the engine for every property under one setting, and describes disagreements with the
/// oracle and traces that cannot be replayed. An undecided question is a disagreement, unless zones
/// are not extrapolated. \pre `judged` is of `program` \param decided counts the answers
/// \param sliced receives the number of answers of parts
[[nodiscard]] std::optional<std::string>
disagreement(const fiacre::Program& program, const fiacre::Provenance& provenance,
             const Judged& judged, const std::pair<std::string, verify::Options>& setting,
             std::size_t* decided = nullptr, std::uint64_t* sliced = nullptr);

/// The program with a property for each state of each instance and for each tag without one: is it
/// absent?
[[nodiscard]] fiacre::Program askedForControl(fiacre::Program program);

} // namespace proskill::oracle
