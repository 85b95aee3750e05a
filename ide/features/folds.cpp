#include "ide/features/structure.h"

namespace proskill::ide {

namespace {

/// A list of names or an expression has no fold of its own.
bool folds(const syntax::Node& node, char first) {
  return first == '(' || (node.kind >= syntax::NodeKind::UnknownField &&
                          node.kind <= syntax::NodeKind::LastingField);
}

void addForms(FoldList& list, const syntax::Document& document) {
  const std::string_view text = document.text();
  for (const auto& region : document.regions())
    for (std::size_t i = 1; i < region.tree->size(); ++i) {
      const auto& node = (*region.tree)[i];
      const syntax::Range range{node.range.begin + region.range.begin,
                                node.range.end + region.range.begin};
      if (!range.empty() && folds(node, text[range.begin])) list.add(range);
    }
}

/// Adds folds for consecutive lines of comments.
void addComments(FoldList& list, const syntax::Document& document) {
  const std::string_view text = document.text();
  syntax::Range block;
  std::uint32_t last = 0; // last line of the block
  std::uint32_t near = 0;
  for (auto comment : document.comments()) {
    const auto [line, column] = document.lines().position(comment.begin, near);
    const auto before = text.substr(comment.begin - column, column);
    if (before.find_first_not_of(" \t") != std::string_view::npos) continue;
    if (block.empty() || line != last + 1) {
      list.add(block, FoldKind::Comment);
      block.begin = comment.begin;
    }
    block.end = comment.end;
    last = line;
  }
  list.add(block, FoldKind::Comment);
}

} // namespace

std::vector<Fold> folds(const syntax::Document& document) {
  FoldList list(document.lines());
  addForms(list, document);
  addComments(list, document);
  return list.take();
}

} // namespace proskill::ide
