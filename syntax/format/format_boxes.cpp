#include "syntax/format/format_boxes.h"

#include "syntax/text/characters.h"

#include <algorithm>

namespace proskill::syntax {

namespace {

bool isBad(NodeKind kind) {
  return kind == NodeKind::Error || kind == NodeKind::Unexpected ||
         kind == NodeKind::MalformedName || kind == NodeKind::SurplusClose;
}

bool isWord(NodeKind kind) {
  switch (kind) {
  case NodeKind::Token:
  case NodeKind::Symbol:
  case NodeKind::Parameter:
  case NodeKind::Keyword:
  case NodeKind::Number:
  case NodeKind::Operator:
  case NodeKind::String:
  case NodeKind::Access:
  case NodeKind::Unbounded:
  case NodeKind::Boolean:
  case NodeKind::All: return true;
  default: return false;
  }
}

bool isDefinition(NodeKind kind) {
  switch (kind) {
  case NodeKind::StateVariable:
  case NodeKind::Event:
  case NodeKind::Skill:
  case NodeKind::Resource:
  case NodeKind::Environment: return true;
  default: return false;
  }
}

/// Computes sizes in characters; continuation bytes do not count.
class BoxBuilder {
public:
  BoxBuilder(std::string_view text, Offset shift) : text(text), shift(shift) {}

  bool build(const Tree& tree) {
    if (tree.empty()) return false;
    const Node* end = tree.data() + tree.size();
    for (const Node* node = tree.data() + 1; node < end; node += node->size) {
      auto begin = boxes.size();
      addNode(*node);
      if (bad || (begin < boxes.size() && !isTopLevel(boxes[begin]))) return false;
    }
    return true;
  }

  Boxes boxes;

private:
  static bool isTopLevel(const Box& box) {
    return box.shape == BoxShape::Form || box.shape == BoxShape::Comment;
  }

  [[nodiscard]] Range rangeOf(const Node& node) const {
    return {node.range.begin + shift, node.range.end + shift};
  }
  [[nodiscard]] std::string_view textOf(Range range) const {
    return text.substr(range.begin, range.length());
  }

  void addNode(const Node& node) {
    bad |= isBad(node.kind);
    if (bad) return;
    auto range = rangeOf(node);
    if (node.kind == NodeKind::Comment) return addComment(range);
    if (isWord(node.kind)) return addLeaf(node.kind, range);
    if (range.empty()) return;
    if (node.kind == NodeKind::Interval) return addInterval(node);
    bool inParentheses = text[range.begin] == '(';
    bad |= inParentheses && (range.length() < 2 || text[range.end - 1] != ')');
    addNested(node, inParentheses ? BoxShape::Form : BoxShape::Group);
  }

  void addLeaf(NodeKind kind, Range range) {
    boxes.push_back({BoxShape::Word, kind, 1, range, widthOf(textOf(range)), 0});
  }

  void addComment(Range range) {
    auto comment = textOf(range);
    auto length = comment.find_last_not_of(" \t\r") + 1;
    range.end = range.begin + static_cast<Offset>(length);
    boxes.push_back({BoxShape::Comment, NodeKind::Comment, 1, range, kNotFlat, 0});
  }

  /// Adds an interval. One that is incomplete or contains a comment is kept as it is.
  void addInterval(const Node& node) {
    constexpr std::uint32_t kParts = 5; // [ lower , upper ]
    auto at = open(node, BoxShape::Tight);
    for (const Node* child = &node + 1; child < &node + node.size; child += child->size) {
      bad |= !isWord(child->kind);
      addLeaf(child->kind, rangeOf(*child));
      boxes[at].flat += boxes.back().flat;
      ++boxes[at].children;
    }
    bad |= boxes[at].children != kParts;
    close(at);
  }

  std::size_t open(const Node& node, BoxShape shape) {
    boxes.push_back({shape, node.kind, 1, rangeOf(node), 0, 0});
    return boxes.size() - 1;
  }

  void close(std::size_t at) { boxes[at].size = static_cast<std::uint32_t>(boxes.size() - at); }

  /// Adds a group. A trailing comment is put after it, since the end of the group is not visible.
  void addNested(const Node& node, BoxShape shape) {
    auto at = open(node, shape);
    std::size_t end = boxes.size(); // of the last child of the group
    for (const Node* child = &node + 1; child < &node + node.size; child += child->size) {
      addNode(*child);
      // a form that ends with its last child lacks its parenthesis, and ends with the text
      bad |= shape == BoxShape::Form && child->range.end == node.range.end;
      if (bad) return;
      if (shape == BoxShape::Form || child->kind != NodeKind::Comment) {
        end = boxes.size();
        if (shape == BoxShape::Group) boxes[at].range.end = rangeOf(*child).end;
      }
    }
    boxes[at].size = static_cast<std::uint32_t>(end - at);
    measure(at);
  }

  void measure(std::size_t at) {
    Box& box = boxes[at];
    std::uint64_t flat = box.shape == BoxShape::Form ? 2 : 0;
    for (std::size_t child = at + 1; child < at + box.size; child += boxes[child].size) {
      if (boxes[child].flat == kNotFlat) flat = kNotFlat;
      flat += boxes[child].flat + (box.children > 0 ? 1 : 0);
      ++box.children;
    }
    box.flat =
        breaks(at) ? kNotFlat : static_cast<std::uint32_t>(std::min<std::uint64_t>(flat, kNotFlat));
  }

  /// Whether the box takes several lines, however short it is.
  [[nodiscard]] bool breaks(std::size_t at) const {
    const Box& box = boxes[at];
    if (isDefinition(box.kind)) return firstFieldStartsLine(at);
    switch (box.kind) {
    case NodeKind::BodyField: return box.children > 1;
    case NodeKind::TimeoutField: return box.children > 3; // more than one statement
    case NodeKind::Block:
    case NodeKind::PreconditionList:
    case NodeKind::InvariantList: return box.children > 1;
    case NodeKind::Parallel:
    case NodeKind::Race:
    case NodeKind::Choose:
    case NodeKind::If:
    case NodeKind::Case:
    case NodeKind::CaseArm:
    case NodeKind::While:
    case NodeKind::DoUntil:
    case NodeKind::ElseifClause: return box.children > 2;
    case NodeKind::Do:
    case NodeKind::ElseClause: return box.children > 1;
    case NodeKind::OutcomeList: return box.children > 1 && hasClause(at);
    case NodeKind::InvariantClause:
    case NodeKind::OutcomeClause: return box.children > 1;
    case NodeKind::SuccessField:
    case NodeKind::FailureField: return clauseStartsLine(text, boxes, at);
    case NodeKind::NameList:
    case NodeKind::InputList:
    case NodeKind::TransitionList: return hasLines(at);
    default: return false;
    }
  }

  template <class Predicate> [[nodiscard]] bool anyChild(std::size_t at, Predicate holds) const {
    for (std::size_t child = at + 1; child < at + boxes[at].size; child += boxes[child].size)
      if (holds(child)) return true;
    return false;
  }

  /// Whether the user broke the line before the first field. If not, a short definition stays on
  /// one line.
  [[nodiscard]] bool firstFieldStartsLine(std::size_t at) const {
    Offset before = boxes[at].range.begin;
    for (std::size_t child = at + 1; child < at + boxes[at].size; child += boxes[child].size) {
      if (isField(boxes[child].kind)) return lineEndsIn(text, before, boxes[child].range.begin);
      before = boxes[child].range.end;
    }
    return false;
  }

  [[nodiscard]] bool hasClause(std::size_t at) const {
    return anyChild(at, [&](std::size_t child) { return boxes[child].children > 1; });
  }

  /// Whether the user broke a line between two items of a list.
  [[nodiscard]] bool hasLines(std::size_t at) const {
    Offset before = 0;
    return anyChild(at, [&](std::size_t child) {
      bool broken = before > 0 && lineEndsIn(text, before, boxes[child].range.begin);
      before = boxes[child].range.end;
      return broken;
    });
  }

  std::string_view text;
  Offset shift;
  bool bad = false;
};

} // namespace

bool isField(NodeKind kind) {
  return kind >= NodeKind::UnknownField && kind <= NodeKind::LastingField;
}

bool lineEndsIn(std::string_view text, Offset from, Offset to) {
  return text.substr(from, to - from).find('\n') != std::string_view::npos;
}

bool clauseStartsLine(std::string_view text, const Boxes& boxes, std::size_t field) {
  constexpr std::uint32_t kTagAndClause = 2;
  auto at = field + 2; // after the keyword
  if (boxes[field].children != kTagAndClause || boxes[at].kind != NodeKind::Outcome) return false;
  const Box& tag = boxes[at + 1];
  return boxes[at].children == kTagAndClause &&
         lineEndsIn(text, tag.range.end, boxes[at + 2].range.begin);
}

std::optional<Boxes> boxesOf(std::string_view text, const Region& region) {
  if (!region.readAsIs) return std::nullopt;
  BoxBuilder builder(text, region.range.begin);
  if (!builder.build(*region.tree)) return std::nullopt;
  return std::move(builder.boxes);
}

} // namespace proskill::syntax
