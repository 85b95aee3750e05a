#pragma once

#include "cli/output/tina_backend.h"

#include <string>
#include <vector>

namespace proskill::cli {

/// Where the engine and Tina are not of one mind.
struct Difference {
  std::string property; ///< its name; empty: the model as a whole
  std::string engine;
  std::string tina;
};

/// Of properties that both decided; and of counterexamples of Tina's that the engine cannot follow.
/// \pre the same properties, in the same order
[[nodiscard]] std::vector<Difference> differencesBetween(const ide::VerificationReport& engine,
                                                         const ide::VerificationReport& tina);

/// "the engine and Tina agree on 3 of 5 properties; 2 cannot be compared". \pre they do not differ
[[nodiscard]] std::string agreement(const ide::VerificationReport& engine,
                                    const ide::VerificationReport& tina);

/// The first few names of the properties that differ.
[[nodiscard]] std::string namesOf(const std::vector<Difference>& differences);

/// A bug report in Markdown that is ready to be sent: what differs, versions, the program, the
/// model, and all that both said.
[[nodiscard]] std::string differenceReport(const report::VerifyReport& engine, const TinaRun& tina,
                                           const std::vector<Difference>& differences);

/// A name for a new file: `path`, or `path` with a number, so that nothing is overwritten.
[[nodiscard]] std::filesystem::path unusedName(const std::filesystem::path& path);

} // namespace proskill::cli
