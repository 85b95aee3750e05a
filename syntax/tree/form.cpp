#include "syntax/tree/form.h"

#include "syntax/tree/shift.h"
#include "syntax/tree/statements.h"

#include <memory_resource>
#include <mutex>

namespace proskill::syntax {

namespace {

/// Memory that a byte of text takes, approximately.
constexpr std::size_t kBytesOfText = 12;

Name nameOf(const ReadForm& form) {
  return std::visit(
      [&](const auto& node) {
        if constexpr (requires { node.name; }) return node.name;
        return Name{{}, {form.range.begin, form.range.begin}};
      },
      form.node);
}

const Block* bodyOf(const FormNode& node) {
  if (const auto* skill = std::get_if<Skill>(&node)) return skill->body ? &*skill->body : nullptr;
  if (const auto* environment = std::get_if<Environment>(&node)) return &environment->body;
  return nullptr;
}

} // namespace

BodyIndex bodyIndexOf(const FormNode& node) {
  BodyIndex found;
  const Block* body = bodyOf(node);
  if (!body) return found;
  forEachStatement(*body, [&](const Statement& statement) {
    if (statement.kind == StatementKind::Call) found.calls.push_back(&statement);
    if (statement.kind == StatementKind::Label) found.labels.push_back(&statement);
    if (runsBranches(statement)) found.parallels.push_back(&statement);
  });
  return found;
}

class PlacedNode {
public:
  PlacedNode(std::shared_ptr<const ReadForm> read, Offset by) : read(std::move(read)), by(by) {}

  const std::shared_ptr<const ReadForm> read;

  [[nodiscard]] const FormNode& node() const {
    if (by == 0) return read->node;
    std::call_once(once, [this] { copy = std::make_unique<const Copy>(*read, by); });
    return copy->node;
  }

private:
  /// A copy in memory of its own.
  struct Copy {
    std::pmr::monotonic_buffer_resource arena;
    FormNode node;

    Copy(const ReadForm& form, Offset by) : arena(kBytesOfText * form.range.length()) {
      const ArenaScope inArena(arena);
      node = form.node;
      shift(node, by);
    }
  };

  const Offset by;
  mutable std::once_flag once;
  mutable std::unique_ptr<const Copy> copy;
};

Form::Form(std::shared_ptr<const ReadForm> form)
    : range(form->range),
      keyword(form->keyword),
      name(nameOf(*form)),
      recovered(form->recovered),
      kind(static_cast<std::uint8_t>(form->node.index())),
      read(form.get()),
      placed(std::make_shared<const PlacedNode>(std::move(form), 0)) {}

Form Form::moved(Offset further) const {
  Form result = *this;
  if (further == 0) return result;
  for (Range* each : {&result.range, &result.keyword.range, &result.name.range})
    *each = each->moved(further);
  if (!comment.empty()) result.comment = comment.moved(further);
  result.by += further;
  result.placed = std::make_shared<const PlacedNode>(placed->read, result.by);
  return result;
}

const FormNode& Form::node() const { return placed->node(); }

} // namespace proskill::syntax
