#pragma once

#include "ide/answers/fold.h"
#include "ide/snapshot/snapshot.h"

#include <string>
#include <vector>

/// What can be told of a text from its form alone: folds, selections, links.
namespace proskill::ide {

/// By their first lines, which all differ.
[[nodiscard]] std::vector<Fold> folds(const syntax::Document& document);

/// What grows around a place: its word, the expression, the statement, …, the whole text; each
/// holds the one before it.
[[nodiscard]] std::vector<syntax::Range> selections(const syntax::Document& document,
                                                    syntax::Offset at);

/// A path in a text, and the file that it names.
struct DocumentLink {
  syntax::Range range; ///< between the quotes
  std::filesystem::path target;
};

[[nodiscard]] std::vector<DocumentLink> links(const std::filesystem::path& file,
                                              const syntax::Document& document);

} // namespace proskill::ide
