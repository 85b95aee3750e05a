#pragma once

#include "cli/output/tina_backend.h"

#include <string>
#include <vector>

namespace proskill::cli {

/// A disagreement between the engine and Tina.
struct Difference {
  std::string property; ///< name of the property; empty: the whole model
  std::string engine;
  std::string tina;
};

/// Compares the verdicts on properties that both decided, and lists counterexamples of Tina that
/// the engine cannot replay.
/// \pre the same properties, in the same order
[[nodiscard]] std::vector<Difference> differencesBetween(const ide::VerificationReport& engine,
                                                         const ide::VerificationReport& tina);

/// "the engine and Tina agree on 3 of 5 properties; 2 cannot be compared". \pre there is no
/// difference
[[nodiscard]] std::string agreement(const ide::VerificationReport& engine,
                                    const ide::VerificationReport& tina);

/// The names of the first few properties that differ.
[[nodiscard]] std::string namesOf(const std::vector<Difference>& differences);

/// A bug report in Markdown, ready to be sent: the differences, versions, the program, the model,
/// and the full output of both.
[[nodiscard]] std::string differenceReport(const report::VerifyReport& engine, const TinaRun& tina,
                                           const std::vector<Difference>& differences);

/// A name for a new file that overwrites nothing: `path`, or `path` with a number.
[[nodiscard]] std::filesystem::path unusedName(const std::filesystem::path& path);

} // namespace proskill::cli
