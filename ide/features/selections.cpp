#include "ide/features/structure.h"

#include <algorithm>

namespace proskill::ide {

namespace {

bool holds(syntax::Range range, syntax::Offset at) { return range.begin <= at && at <= range.end; }

/// Ranges from the outside in, each contained in the previous one.
class Selecting {
public:
  Selecting(std::string_view text, syntax::Offset at) : text(text), at(at) {}

  void add(syntax::Range range) {
    if (!holds(range, at) || range.empty()) return;
    if (!result.empty() && (result.back() == range || !isWithin(range, result.back()))) return;
    result.push_back(range);
  }

  /// Adds a node, and what is between its parentheses or quotes.
  void addNode(syntax::Range range) {
    add(range);
    bool enclosed = range.length() >= 2 && std::string_view("(\"").contains(text[range.begin]) &&
                    std::string_view(")\"").contains(text[range.end - 1]);
    if (enclosed && range.begin < at && at < range.end) add({range.begin + 1, range.end - 1});
  }

  std::vector<syntax::Range> run() && {
    std::ranges::reverse(result);
    return std::move(result);
  }

private:
  static bool isWithin(syntax::Range inner, syntax::Range outer) {
    return outer.begin <= inner.begin && inner.end <= outer.end;
  }

  std::string_view text;
  syntax::Offset at;
  std::vector<syntax::Range> result;
};

/// Where two nodes touch, the one that begins at the position is selected.
void addNodes(Selecting& selecting, const syntax::Region& region, syntax::Offset at) {
  const auto& tree = *region.tree;
  auto inDocument = [&](const syntax::Node& node) {
    return syntax::Range{node.range.begin + region.range.begin,
                         node.range.end + region.range.begin};
  };
  std::size_t end = tree.size();
  for (std::size_t node = 1; node < end;) {
    auto range = inDocument(tree[node]);
    std::size_t next = node + tree[node].size;
    bool meets = next < end && inDocument(tree[next]).begin == at && range.end == at;
    if (!holds(range, at) || meets) {
      node = next;
      continue;
    }
    selecting.addNode(range);
    end = next;
    ++node;
  }
}

} // namespace

std::vector<syntax::Range> selections(const syntax::Document& document, syntax::Offset at) {
  Selecting selecting(document.text(), at);
  selecting.add({0, static_cast<syntax::Offset>(document.text().size())});
  for (const auto& form : document.forms())
    if (!form.comment.empty()) selecting.add({form.comment.begin, form.range.end});
  const syntax::Region* found = nullptr;
  auto regions = document.regions();
  for (const auto& region : regions)
    if (holds(region.range, at)) found = &region;
  if (found) addNodes(selecting, *found, at);
  auto result = std::move(selecting).run();
  if (result.empty()) result.push_back({at, at});
  return result;
}

} // namespace proskill::ide
