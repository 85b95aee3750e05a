#pragma once

#include "ide/answers/fold.h"
#include "ide/snapshot/snapshot.h"

#include <string>
#include <vector>

/// Features that need only the syntax of a text: folds, selection ranges, links.
namespace proskill::ide {

/// Ordered by their first lines, which are all different.
[[nodiscard]] std::vector<Fold> folds(const syntax::Document& document);

/// The ranges around a place: its word, the expression, the statement, …, the whole text; each
/// contains the one before it.
[[nodiscard]] std::vector<syntax::Range> selections(const syntax::Document& document,
                                                    syntax::Offset at);

/// A path in a text, and the file to which it refers.
struct DocumentLink {
  syntax::Range range; ///< between the quotes
  std::filesystem::path target;
};

[[nodiscard]] std::vector<DocumentLink> links(const std::filesystem::path& file,
                                              const syntax::Document& document);

} // namespace proskill::ide
