#pragma once

#include "verify/verify.h"

#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Parsers of the tools' output, as described in docs/tina.md. An unexpected text gives
/// nothing, never a guess.
namespace proskill::tina {

/// The formulas that frac makes of a model's properties (`model.ltl`).
struct LtlFile {
  std::string definitions;          ///< `op name = …;`, the prelude among them
  std::vector<std::string> queries; ///< one for each `assert`, in order, without its `;`
};
[[nodiscard]] LtlFile readLtl(std::string_view text);

/// The four counts that sift ends with; or, of tina's digest, the numbers of states (as classes)
/// and of transitions.
[[nodiscard]] std::optional<verify::Exploration> readCounts(std::string_view output);

/// Whether an explorer says that it stopped early: then its graph gives no verdict.
[[nodiscard]] bool saysUnfinished(std::string_view output);

/// The verdicts of selt, in the order of the formulas; nothing if their number differs.
[[nodiscard]] std::optional<std::vector<bool>> readVerdicts(std::string_view output,
                                                            std::size_t expected);

/// The transitions of a scenario (`.scn`), without their dates; nothing where there is none.
[[nodiscard]] std::optional<std::vector<std::string>> readScenario(std::string_view text);

/// The transitions in a counterexample as selt prints it: lines `-NAME … ->`.
[[nodiscard]] std::vector<std::string> readCounterexample(std::string_view output);

} // namespace proskill::tina
