#pragma once

#include "codegen/model.h"
#include "fiacre/check/check.h"
#include "ide/snapshot/snapshot.h"
#include "syntax/text/edit.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// A model written in Fiacre, in the same data types as ProSkill programs.
namespace proskill::ide {

struct FiacreFile {
  analysis::Program program; ///< no definitions; `files[0]` is the text
  std::vector<syntax::Diagnostic> diagnostics;
  /// The model with a check for each asserted property. Times are in units of the model. Undefined
  /// if there are errors.
  codegen::Model model;

  [[nodiscard]] bool hasErrors() const;
  /// Whether the text names a main component; texts with only environments or properties do not.
  [[nodiscard]] bool isModel() const { return !model.fiacre.main.empty(); }
};

[[nodiscard]] bool isFiacre(const std::filesystem::path& path); ///< whether its name ends in `.fcr`
[[nodiscard]] bool isFiacre(const View& view);

/// Parses and checks a text. Never fails.
/// \param path shown in locations
[[nodiscard]] FiacreFile readFiacre(const std::filesystem::path& path, std::string text);

/// The range of a problem: of its statement or otherwise of the name that it concerns. `{0, 0}` if
/// the text contains neither.
[[nodiscard]] syntax::Range rangeOf(const fiacre::Problem& problem,
                                    const fiacre::Provenance& provenance, std::string_view text);

/// The edits that format a Fiacre text, in order; nothing if it cannot be parsed.
[[nodiscard]] std::optional<std::vector<syntax::TextEdit>> formatFiacre(std::string_view text);

} // namespace proskill::ide
