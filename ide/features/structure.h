#pragma once

#include "ide/snapshot/snapshot.h"

#include <string>
#include <vector>

/// What can be told of a text from its form alone: folds, selections, links.
namespace proskill::ide {

enum class FoldKind : std::uint8_t { Form, Comment };

/// Lines that can be folded into the first of them.
struct Fold {
  std::uint32_t firstLine = 0;
  std::uint32_t lastLine = 0; ///< > firstLine
  FoldKind kind = FoldKind::Form;

  friend bool operator==(const Fold&, const Fold&) = default;
};

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
