#pragma once

#include "codegen/model.h"
#include "fiacre/check/check.h"
#include "ide/snapshot/snapshot.h"
#include "syntax/text/edit.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// A model that a user writes in Fiacre, in the shapes that programs of ProSkill have.
namespace proskill::ide {

struct FiacreFile {
  analysis::Program program; ///< no definitions; `files[0]` is the text
  std::vector<syntax::Diagnostic> diagnostics;
  /// A check for each property that is asserted, by its name. Times are in units of the model.
  /// Means nothing where there are errors.
  codegen::Model model;

  [[nodiscard]] bool hasErrors() const;
  /// Whether it names what is the model: environments and properties alone are none.
  [[nodiscard]] bool isModel() const { return !model.fiacre.main.empty(); }
};

[[nodiscard]] bool isFiacre(const std::filesystem::path& path); ///< by its name: `.fcr`
[[nodiscard]] bool isFiacre(const View& view);

/// Reads and checks a text; `path` is what places show. Never fails.
[[nodiscard]] FiacreFile readFiacre(const std::filesystem::path& path, std::string text);

/// The place of a problem in the text that has it: of its statement, or else of the name that it
/// is about. `{0, 0}` where it is in none of them.
[[nodiscard]] syntax::Range rangeOf(const fiacre::Problem& problem,
                                    const fiacre::Provenance& provenance, std::string_view text);

/// The edits that lay a text of Fiacre out, in its order; nothing where it cannot be read.
[[nodiscard]] std::optional<std::vector<syntax::TextEdit>> formatFiacre(std::string_view text);

} // namespace proskill::ide
