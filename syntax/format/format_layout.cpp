#include "syntax/format/format_layout.h"

#include "syntax/format/format.h"
#include "syntax/text/characters.h"

#include <algorithm>

namespace proskill::syntax {

namespace {

constexpr std::uint32_t kFieldIndent = 2;  // in a definition, and below a keyword
constexpr std::uint32_t kBodyIndent = 3;   // in `if`, `while`, `do`
constexpr std::uint32_t kClauseIndent = 1; // of `else`, `elseif`, `until`

bool isClause(NodeKind kind) {
  return kind == NodeKind::ElseifClause || kind == NodeKind::ElseClause ||
         kind == NodeKind::UntilClause;
}

/// Whether the statement has a part on the line of its head: a condition, or the call of a `case`.
bool hasCondition(NodeKind kind) { return kind != NodeKind::Do && kind != NodeKind::ElseClause; }

/// A byte order mark is not part of the first gap.
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

} // namespace

void Layout::region(const Boxes& all) {
  boxes = &all;
  if (previousEnd == 0 && text.starts_with(kByteOrderMark)) previousEnd = kByteOrderMark.size();
  for (Index at = 0; at < all.size(); at = nextOf(at)) {
    const Box& top = all[at];
    if (top.shape == BoxShape::Comment) {
      comment(at, 0);
      lastWasForm = false;
      continue;
    }
    auto begin = gaps.size();
    auto before = written;
    box(at, line(0), 0);
    bool tall = written > before + (begin < gaps.size() ? gaps[begin].lines : 0);
    bool apart = begin < gaps.size() && lastWasForm && tall && lastWasTall;
    if (apart) gaps[begin].lines = 2;
    lastWasForm = true;
    lastWasTall = tall;
  }
}

void Layout::box(Index at, Separator before, std::uint32_t after, std::uint32_t hang) {
  if (fits(at, before, after))
    flat(at, before);
  else
    broken(at, before, after, hang);
}

void Layout::flat(Index at, Separator before) {
  const Box& box = (*boxes)[at];
  switch (box.shape) {
  case BoxShape::Comment:
  case BoxShape::Word: return token(box.range, before);
  case BoxShape::Form: token({box.range.begin, box.range.begin + 1}, before); break;
  case BoxShape::Group:
  case BoxShape::Tight: break;
  }
  auto first = box.shape == BoxShape::Form ? none(column) : before;
  for (Index child = at + 1; child < endOf(at); child = nextOf(child)) {
    bool isFirst = child == at + 1;
    flat(child, isFirst ? first : box.shape == BoxShape::Tight ? none(column) : space(column));
  }
  if (box.shape == BoxShape::Form) close(at, column);
}

void Layout::broken(Index at, Separator before, std::uint32_t after, std::uint32_t hang) {
  const Box& box = (*boxes)[at];
  switch (box.kind) {
  case NodeKind::StateVariable:
  case NodeKind::Event:
  case NodeKind::Skill:
  case NodeKind::Resource:
  case NodeKind::Environment: return definition(at, before, after);
  case NodeKind::Property: return property(at, before, after);
  case NodeKind::BodyField: return body(at, before, after);
  case NodeKind::TimeoutField: return timeout(at, before, after);
  case NodeKind::Precondition:
  case NodeKind::Invariant:
  case NodeKind::Outcome:
  case NodeKind::Argument:
  case NodeKind::Input: return tagged(at, before, after, hang);
  case NodeKind::If:
  case NodeKind::Case:
  case NodeKind::While:
  case NodeKind::Do:
  case NodeKind::DoUntil:
  case NodeKind::ElseifClause:
  case NodeKind::ElseClause:
  case NodeKind::UntilClause: return control(at, before, after);
  case NodeKind::NameList:
  case NodeKind::InputList:
  case NodeKind::TransitionList: return list(at, before, after);
  case NodeKind::Block:
  case NodeKind::CaseArm:
  case NodeKind::PreconditionList:
  case NodeKind::InvariantList:
  case NodeKind::OutcomeList:
  case NodeKind::EffectList:
  case NodeKind::InvariantClause:
  case NodeKind::OutcomeClause:
  case NodeKind::InterruptClause: return lines(at, before, after);
  case NodeKind::Call:
  case NodeKind::Command:
  case NodeKind::Printf: return headed(at, before, after, true);
  default: break;
  }
  if (box.shape == BoxShape::Form) return headed(at, before, after, false);
  if (clauseStartsLine(text, *boxes, at)) return hanging(at, before, after);
  if (isField(box.kind)) return field(at, before, after);
  if (box.shape == BoxShape::Group) return tagged(at, before, after, hang);
  flat(at, before);
}

void Layout::form(Index at, Separator before, std::uint32_t indent,
                  const std::function<void(Index, bool)>& place) {
  const Box& box = (*boxes)[at];
  token({box.range.begin, box.range.begin + 1}, before);
  bool first = true;
  for (Index child = at + 1; child < endOf(at); child = nextOf(child)) {
    if ((*boxes)[child].shape == BoxShape::Comment) {
      comment(child, indent);
      continue;
    }
    place(child, first);
    first = false;
  }
  close(at, indent);
}

void Layout::definition(Index at, Separator before, std::uint32_t after) {
  std::uint32_t indent = columnOf(before) + kFieldIndent;
  form(at, before, indent, [&](Index child, bool first) {
    auto kind = (*boxes)[child].kind;
    auto between = isField(kind) ? line(indent) : first ? none(indent) : space(indent);
    box(child, between, afterChild(at, child, after));
  });
}

void Layout::property(Index at, Separator before, std::uint32_t after) {
  std::uint32_t indent = columnOf(before) + kFieldIndent;
  form(at, before, indent, [&](Index child, bool first) {
    bool isPattern = (*boxes)[child].shape == BoxShape::Form;
    auto between = isPattern ? line(indent) : first ? none(indent) : space(indent);
    box(child, between, afterChild(at, child, after));
  });
}

void Layout::body(Index at, Separator before, std::uint32_t after) {
  std::uint32_t indent = columnOf(before) + kFieldIndent;
  for (Index child = at + 1; child < endOf(at); child = nextOf(child)) {
    if ((*boxes)[child].shape == BoxShape::Comment)
      comment(child, indent);
    else if (child == at + 1)
      token((*boxes)[child].range, before);
    else
      box(child, line(indent), afterChild(at, child, after));
  }
}

/// Writes the statements below the time.
void Layout::timeout(Index at, Separator before, std::uint32_t after) {
  std::uint32_t indent = columnOf(before) + kFieldIndent;
  std::size_t count = 0;
  for (Index child = at + 1; child < endOf(at); child = nextOf(child)) {
    if ((*boxes)[child].shape == BoxShape::Comment) {
      comment(child, indent);
      continue;
    }
    auto between = count == 0 ? before : count == 1 ? space(indent) : line(indent);
    box(child, between, afterChild(at, child, after));
    ++count;
  }
}

void Layout::field(Index at, Separator before, std::uint32_t after) {
  std::uint32_t base = columnOf(before);
  auto layOut = [&](bool below) {
    std::uint32_t align = base + kFieldIndent;
    bool first = true;
    token((*boxes)[at + 1].range, before);
    bool commented = nextOf(at + 1) < endOf(at) && (*boxes)[at + 2].shape == BoxShape::Comment;
    if (!below && !commented) align = column + 1;
    for (Index child = nextOf(at + 1); child < endOf(at); child = nextOf(child)) {
      if ((*boxes)[child].shape == BoxShape::Comment) {
        comment(child, align);
        continue;
      }
      auto between = first && !below ? space(align) : line(align);
      box(child, between, afterChild(at, child, after), base + kFieldIndent);
      first = false;
    }
  };
  betterOf([&] { layOut(false); }, [&] { layOut(true); });
}

void Layout::tagged(Index at, Separator before, std::uint32_t after, std::uint32_t hang) {
  std::uint32_t indent = hang > 0 ? hang : columnOf(before) + kFieldIndent;
  auto layOut = [&](bool below) {
    for (Index child = at + 1; child < endOf(at); child = nextOf(child)) {
      if ((*boxes)[child].shape == BoxShape::Comment)
        comment(child, indent);
      else
        box(child,
            child == at + 1 ? before
            : below         ? line(indent)
                            : space(indent),
            afterChild(at, child, after));
    }
  };
  betterOf([&] { layOut(false); }, [&] { layOut(true); });
}

/// Writes `:success tag`, and the tag's clause below.
void Layout::hanging(Index at, Separator before, std::uint32_t after) {
  std::uint32_t indent = columnOf(before) + kFieldIndent;
  Index outcome = at + 2;
  token((*boxes)[at + 1].range, before);
  token((*boxes)[outcome + 1].range, space(indent));
  box(outcome + 2, line(indent), after);
}

void Layout::control(Index at, Separator before, std::uint32_t after) {
  const Box& whole = (*boxes)[at];
  bool isForm = whole.shape == BoxShape::Form;
  std::uint32_t base = columnOf(before);
  std::uint32_t clauses = base + kClauseIndent;
  std::uint32_t statements = base + kBodyIndent - (isForm ? 0 : kClauseIndent);
  std::size_t onFirstLine = hasCondition(whole.kind) ? 2 : 1;
  std::size_t count = 0;
  if (isForm) token({whole.range.begin, whole.range.begin + 1}, before);
  for (Index child = at + 1; child < endOf(at); child = nextOf(child)) {
    const Box& part = (*boxes)[child];
    if (part.shape == BoxShape::Comment) {
      comment(child, commentBelongsToNext(child, at) ? clauses : statements);
      continue;
    }
    auto between = isClause(part.kind) ? line(clauses) : line(statements);
    if (!isClause(part.kind) && count == 0) between = isForm ? none(statements) : before;
    if (!isClause(part.kind) && count > 0 && count < onFirstLine) between = space(statements);
    ++count;
    box(child, between, afterChild(at, child, after));
  }
  if (isForm) close(at, statements);
}

/// Fills lines with items, and keeps the user's line breaks.
void Layout::list(Index at, Separator before, std::uint32_t after) {
  std::uint32_t indent = columnOf(before) + 1;
  form(at, before, indent, [&](Index child, bool first) {
    const Box& item = (*boxes)[child];
    auto room = afterChild(at, child, after);
    bool breaks = !first && (lineEndsIn(text, previousEnd, item.range.begin) ||
                             !fits(child, space(indent), room));
    box(child, first ? none(indent) : breaks ? line(indent) : space(indent), room);
  });
}

void Layout::lines(Index at, Separator before, std::uint32_t after) {
  std::uint32_t indent = columnOf(before) + 1;
  form(at, before, indent, [&](Index child, bool first) {
    box(child, first ? none(indent) : line(indent), afterChild(at, child, after));
  });
}

void Layout::headed(Index at, Separator before, std::uint32_t after, bool filled) {
  std::uint32_t indent = columnOf(before) + 1;
  std::size_t count = 0;
  form(at, before, indent, [&](Index child, bool) {
    auto room = afterChild(at, child, after);
    auto between = line(indent);
    if (count == 0) between = none(indent);
    if (count == 1 || (count > 1 && filled && fits(child, space(indent), room)))
      between = space(indent);
    box(child, between, room);
    if (count == 0 && !lineMustEnd) indent = column + 1;
    ++count;
  });
}

/// The space needed after a child on its line: after the last child, the parent's parenthesis and
/// what follows the parent; after others none, since the next can move to a new line.
std::uint32_t Layout::afterChild(Index parent, Index child, std::uint32_t after) const {
  if (nextOf(child) != endOf(parent)) return 0;
  return after + ((*boxes)[parent].shape == BoxShape::Form ? 1 : 0);
}

/// Whether a comment before `else` belongs to it: if it is indented as little as the `else`.
bool Layout::commentBelongsToNext(Index comment, Index parent) const {
  Index next = comment;
  while (next < endOf(parent) && (*boxes)[next].shape == BoxShape::Comment) next = nextOf(next);
  if (next >= endOf(parent) || !isClause((*boxes)[next].kind)) return false;
  return columnIn((*boxes)[comment].range.begin) <= columnIn((*boxes)[next].range.begin);
}

bool Layout::fits(Index at, Separator before, std::uint32_t after) const {
  auto width = (*boxes)[at].flat;
  return width != kNotFlat && std::uint64_t{columnOf(before)} + width + after <= kLineWidth;
}

/// Chooses the second layout if the first is too wide and the second is narrower.
void Layout::betterOf(const std::function<void()>& first, const std::function<void()>& second) {
  const Layout* self = this;
  struct State {
    Offset previousEnd;
    std::uint32_t column, written;
    bool lineMustEnd, frozen;
    std::size_t gaps, trailing;
  } before{self->previousEnd, column, written, lineMustEnd, frozen, gaps.size(), trailing.size()};
  auto reached = widest;
  auto restore = [&] {
    previousEnd = before.previousEnd;
    column = before.column;
    written = before.written;
    lineMustEnd = before.lineMustEnd;
    frozen = before.frozen;
    gaps.resize(before.gaps);
    trailing.resize(before.trailing);
  };
  auto widthOf = [&](const std::function<void()>& attempt) {
    widest = 0;
    attempt();
    return widest;
  };
  auto firstWidth = widthOf(first);
  if (firstWidth > kLineWidth) {
    restore();
    if (widthOf(second) >= firstWidth) {
      restore();
      widthOf(first);
    }
  }
  widest = std::max(widest, reached);
}

} // namespace proskill::syntax
