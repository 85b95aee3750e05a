#include "ide/structure.h"

#include <map>

namespace proskill::ide {

namespace {

/// A list of names, or an expression, is not worth a fold of its own.
bool folds(const syntax::Node& node, char first) {
  return first == '(' || (node.kind >= syntax::NodeKind::UnknownField &&
                          node.kind <= syntax::NodeKind::LastingField);
}

class Folding {
public:
  explicit Folding(const syntax::Document& document)
      : lines(document.lines()), text(document.text()) {}

  void add(syntax::Range range, FoldKind kind) {
    if (range.empty()) return;
    auto first = lines.position(range.begin).line;
    auto last = lines.position(range.end).line;
    if (last <= first) return;
    auto [entry, isNew] = found.try_emplace(first, Fold{first, last, kind});
    if (!isNew && entry->second.lastLine < last) entry->second = {first, last, kind};
  }

  /// Comments in lines of their own, one below the other.
  void addComments(const std::vector<syntax::Range>& comments) {
    syntax::Range block;
    for (auto comment : comments) {
      if (!standsAlone(comment)) continue;
      bool goesOn = !block.empty() &&
                    lines.position(comment.begin).line == lines.position(block.end).line + 1;
      if (!goesOn) {
        add(block, FoldKind::Comment);
        block.begin = comment.begin;
      }
      block.end = comment.end;
    }
    add(block, FoldKind::Comment);
  }

  [[nodiscard]] std::vector<Fold> all() const {
    std::vector<Fold> result;
    for (const auto& [line, fold] : found) result.push_back(fold);
    return result;
  }

private:
  [[nodiscard]] bool standsAlone(syntax::Range comment) const {
    auto column = lines.position(comment.begin).column;
    auto before = text.substr(comment.begin - column, column);
    return before.find_first_not_of(" \t") == std::string_view::npos;
  }

  const syntax::LineIndex& lines;
  std::string_view text;
  std::map<std::uint32_t, Fold> found;
};

} // namespace

std::vector<Fold> folds(const syntax::Document& document) {
  Folding folding(document);
  for (const auto& stretch : document.stretches())
    for (const auto& node : *stretch.tree) {
      if (&node == stretch.tree->data() || node.range.empty()) continue;
      syntax::Range range{node.range.begin + stretch.range.begin,
                          node.range.end + stretch.range.begin};
      if (folds(node, document.text()[range.begin])) folding.add(range, FoldKind::Form);
    }
  folding.addComments(document.comments());
  return folding.all();
}

} // namespace proskill::ide
