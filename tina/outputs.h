#pragma once

#include "verify/verify.h"

#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Parsers of the tools' output, as described in docs/tina.md. Unexpected output gives nothing,
/// never a guess.
namespace proskill::tina {

/// The formulas that frac generates for a model's properties (`model.ltl`).
struct LtlFile {
  std::string definitions;          ///< `op name = …;`, including the prelude
  std::vector<std::string> queries; ///< one per `assert`, in order, without `;`
};
[[nodiscard]] LtlFile readLtl(std::string_view text);

/// The four counts at the end of sift's output; or, from tina's digest, the numbers of states (as
/// classes) and of transitions.
[[nodiscard]] std::optional<verify::Exploration> readCounts(std::string_view output);

/// Whether an explorer reports that it stopped early; then its graph gives no verdicts.
[[nodiscard]] bool saysUnfinished(std::string_view output);

/// The verdicts of selt, in the order of the formulas; nothing if their number differs.
[[nodiscard]] std::optional<std::vector<bool>> readVerdicts(std::string_view output,
                                                            std::size_t expected);

/// The transitions of a scenario (`.scn`) without dates; nothing if there is none.
[[nodiscard]] std::optional<std::vector<std::string>> readScenario(std::string_view text);

/// The transitions of a counterexample printed by selt: lines `-NAME … ->`.
[[nodiscard]] std::vector<std::string> readCounterexample(std::string_view output);

} // namespace proskill::tina
