#include "verify/compile/path_writer.h"

#include "verify/unsupported.h"

#include <algorithm>
#include <utility>

namespace proskill::verify {

using fiacre::Statement;
using fiacre::StatementKind;

namespace {

constexpr std::size_t kMostChoices = 4096;
constexpr std::size_t kMostPaths = 10'000; // of one `from`

bool sendsValue(const Statement& statement) {
  return (statement.kind == StatementKind::Send && !statement.values.empty()) ||
         std::ranges::any_of(statement.children, sendsValue);
}

/// Whether the rest may send a value. A sent value is an expression over the state before the path,
/// so a conditional before it has to split the path.
bool mayStillSend(const RestOfPath& rest) {
  return std::ranges::any_of(rest, [](const auto* statement) { return sendsValue(*statement); });
}

} // namespace

void PathWriter::write(PathDraft draft, RestOfPath rest) {
  while (!rest.empty() && !draft.ended) {
    const Statement& statement = *rest.back();
    rest.pop_back();
    bool choice = statement.kind == StatementKind::If || statement.kind == StatementKind::Case;
    if (statement.kind == StatementKind::While) {
      if (!isPlain(statement) || endsPath(statement))
        unsupported("a `while` with more in it than data", statement.origin);
      codeAll(draft, {&statement});
      continue;
    }
    if (choice) {
      bool plain = isPlain(statement) && !mayStillSend(rest);
      if (plain && endsPath(statement))
        plain = std::ranges::all_of(rest, [](const auto* next) { return isPlain(*next); });
      if (plain) {
        if (!endsPath(statement)) {
          codeAll(draft, {&statement});
          continue;
        }
        codeAll(draft, withNext(std::move(rest), statement));
        break;
      }
      noteOrigin(statement, draft);
      return statement.kind == StatementKind::If ? splitIf(statement, draft, rest)
                                                 : splitCase(statement, draft, rest);
    }
    if (statement.kind == StatementKind::Select) {
      noteOrigin(statement, draft);
      return select(statement, draft, rest);
    }
    if (statement.kind == StatementKind::Any) {
      noteOrigin(statement, draft);
      return any(statement, draft, rest);
    }
    if (!step(statement, draft, rest)) return;
  }
  finish(std::move(draft));
}

/// Adds a statement that does not branch. \return false if no path continues from here
bool PathWriter::step(const Statement& statement, PathDraft& draft, RestOfPath& rest) {
  noteOrigin(statement, draft);
  switch (statement.kind) {
  case StatementKind::Null:
  case StatementKind::Comment: return true;
  case StatementKind::Assign: assign(statement, draft); return true;
  case StatementKind::On: {
    NodeId condition = scalar(statement.values.at(0));
    require(condition, draft, statement.origin);
    return nodes().constant(condition) != 0;
  }
  case StatementKind::Wait:
    if (draft.path.wait) unsupported("two waits on one path", statement.origin);
    draft.path.wait = statement.interval;
    return true;
  case StatementKind::To:
  case StatementKind::Loop: end(statement, draft); return true;
  case StatementKind::Sequence:
    for (auto child = statement.children.rbegin(); child != statement.children.rend(); ++child)
      rest.push_back(&*child);
    return true;
  case StatementKind::Send: send(statement, draft); return true;
  case StatementKind::Receive: receive(statement, draft); return true;
  case StatementKind::Foreach:
    foreach (statement, rest)
      ;
    return true;
  case StatementKind::Tag:
    addInstruction(draft, InstructionKind::Tag).event = context.tag(statement.name);
    return true;
  case StatementKind::Any:
  case StatementKind::If:
  case StatementKind::Case:
  case StatementKind::Select:
  case StatementKind::While:
  case StatementKind::Return: unsupported("a statement that is not verified yet", statement.origin);
  case StatementKind::Start:
  case StatementKind::Sync:
    unsupported("tasks are for execution, so this model can be checked but not verified",
                statement.origin);
  }
  std::unreachable();
}

void PathWriter::require(NodeId condition, PathDraft& draft, fiacre::OriginId origin) {
  if (!draft.assigned) {
    if (expressions.mayFail(condition))
      draft.path.risks.push_back(
          {nodes().both(draft.path.guard, nodes().fails(condition)), condition, origin});
    draft.path.guard = nodes().both(draft.path.guard, condition);
    return;
  }
  addInstruction(draft, InstructionKind::On).node = condition;
  draft.path.tentative = true;
}

void PathWriter::assign(const Statement& statement, PathDraft& draft) {
  auto first = static_cast<std::uint32_t>(draft.path.assignments.size());
  for (std::size_t i = 0; i < statement.targets.size(); ++i) {
    const auto& type = expressions.typeOf(statement.targets[i], *context.scope);
    Value source = expressions.value(statement.values.at(i), *context.scope, &type);
    expressions.assign(statement.targets[i], source, *context.scope, draft.path.assignments, first);
  }
  addAssignments(draft, first);
}

/// The assignments from `first` on are simultaneous.
void PathWriter::addAssignments(PathDraft& draft, std::uint32_t first) {
  auto& instruction = addInstruction(draft, InstructionKind::Assign);
  instruction.first = first;
  instruction.last = static_cast<std::uint32_t>(draft.path.assignments.size());
  draft.assigned = true;
  auto next = draft.current;
  for (auto i = first; i < instruction.last; ++i) {
    const auto& assignment = draft.path.assignments[i];
    next[assignment.target] = beforePath(assignment.value, draft);
  }
  draft.current = std::move(next);
}

/// Rewrites a value within the path to an expression over the state before it.
NodeId PathWriter::beforePath(NodeId value, const PathDraft& draft) {
  return nodes().substitute(value, [&](const Node& leaf) -> std::optional<NodeId> {
    if (leaf.op != NodeOp::Cell) return std::nullopt;
    const auto known = draft.current.find(leaf.a);
    return known == draft.current.end() ? std::nullopt : std::optional(known->second);
  });
}

void PathWriter::send(const Statement& statement, PathDraft& draft) {
  synchronise(statement, draft);
  if (!statement.values.empty() && draft.branched)
    unsupported("a value is sent after a `while` on the same path: send it in a state of its own",
                statement.origin);
  const auto& types = context.valuesOf(statement.name);
  for (std::size_t i = 0; i < statement.values.size(); ++i) {
    const auto* type = i < types.size() ? &types[i] : nullptr;
    Value sent = expressions.value(statement.values[i], *context.scope, type);
    if (type) sent = expressions.fitted(std::move(sent), *type, "what goes over the port");
    for (auto part : sent.parts) {
      draft.path.sent.push_back(beforePath(part, draft));
      if (expressions.mayFail(part)) // an error of the sender, whoever receives it
        addInstruction(draft, InstructionKind::On).node = nodes().equal(part, part);
    }
  }
}

/// Assigns the received values first, since `where` reads them.
void PathWriter::receive(const Statement& statement, PathDraft& draft) {
  synchronise(statement, draft);
  const auto first = static_cast<std::uint32_t>(draft.path.assignments.size());
  std::uint32_t part = 0;
  const auto& sent = context.valuesOf(statement.name);
  for (std::size_t i = 0; i < statement.targets.size(); ++i) {
    const auto& target = statement.targets[i];
    if (isWild(target)) {
      if (i < sent.size())
        part += static_cast<std::uint32_t>(expressions.lowest(sent[i]).parts.size());
      continue;
    }
    Value source = expressions.lowest(expressions.typeOf(target, *context.scope));
    for (auto& each : source.parts) each = nodes().received(part++);
    expressions.assign(target, source, *context.scope, draft.path.assignments, first);
  }
  draft.path.receives = true;
  addAssignments(draft, first);
  for (const auto& condition : statement.values)
    require(scalar(condition), draft, statement.origin);
}

/// Adds a path for each value.
void PathWriter::any(const Statement& statement, const PathDraft& draft, const RestOfPath& rest) {
  std::vector<PathDraft> all{draft};
  for (const auto& target : statement.targets) {
    const auto values = expressions.allValues(expressions.typeOf(target, *context.scope));
    std::vector<PathDraft> longer;
    for (const auto& each : all)
      for (auto value = values.low; value <= values.high; ++value) {
        longer.push_back(each);
        assign(expressions.assignmentOf(target, value), longer.back());
      }
    if (longer.size() > kMostChoices) unsupported("`any` has too many values", statement.origin);
    all = std::move(longer);
  }
  for (auto& each : all) {
    for (const auto& condition : statement.values)
      require(scalar(condition), each, statement.origin);
    write(std::move(each), rest);
  }
}

void PathWriter::foreach (const Statement& statement, RestOfPath & rest) {
  const fiacre::Expr variable{.kind = fiacre::ExprKind::Name, .name = statement.name};
  const auto all = expressions.allValues(expressions.typeOf(variable, *context.scope));
  for (auto turn = all.high; turn >= all.low; --turn) {
    rest.push_back(&statement.children.at(0));
    rest.push_back(&expressions.assignmentOf(variable, turn));
  }
}

void PathWriter::synchronise(const Statement& statement, PathDraft& draft) {
  if (draft.path.port != kNone) unsupported("two ports on one path", statement.origin);
  auto port = context.ports.find(statement.name);
  if (port == context.ports.end())
    unsupported("`" + statement.name + "` is not a port of this process", statement.origin);
  draft.path.port = port->second;
}

void PathWriter::end(const Statement& statement, PathDraft& draft) {
  draft.ended = true;
  if (statement.kind == StatementKind::Loop) {
    addInstruction(draft, InstructionKind::Loop).leaf = context.nextLeaf++;
    return;
  }
  const auto& states = context.process->states;
  auto state = std::ranges::find(states, statement.name, &fiacre::State::name);
  if (state == states.end())
    unsupported("`" + statement.name + "` is not a state of this process", statement.origin);
  auto number = static_cast<std::uint32_t>(state - states.begin());
  auto& instruction = addInstruction(draft, InstructionKind::To);
  instruction.first = static_cast<std::uint32_t>(draft.path.assignments.size());
  instruction.last = number;
  instruction.event = context.entering(number);
  instruction.leaf = context.nextLeaf++;
  draft.path.assignments.push_back({context.location, nodes().number(number), false});
}

/// Assigns the variables of a pattern.
void PathWriter::bind(const fiacre::Expr& pattern, const Value& tested, PathDraft& draft) {
  const auto all = expressions.bindings(pattern, tested, *context.scope);
  if (all.empty()) return;
  const auto first = static_cast<std::uint32_t>(draft.path.assignments.size());
  for (const auto& [variable, value] : all)
    expressions.assign(variable, value, *context.scope, draft.path.assignments, first);
  addAssignments(draft, first);
}

void PathWriter::splitIf(const Statement& statement, const PathDraft& draft,
                         const RestOfPath& rest) {
  NodeId condition = scalar(statement.values.at(0));
  const auto take = [&](NodeId guard, const RestOfPath& next) {
    if (nodes().constant(guard) == 0) return;
    PathDraft taken = draft;
    require(guard, taken, statement.origin);
    write(std::move(taken), next);
  };
  take(condition, withNext(rest, statement.children.at(0)));
  take(nodes().negation(condition),
       statement.children.size() > 1 ? withNext(rest, statement.children[1]) : rest);
}

void PathWriter::splitCase(const Statement& statement, const PathDraft& draft,
                           const RestOfPath& rest) {
  Value tested = expressions.value(statement.values.at(0), *context.scope);
  NodeId others = nodes().number(1);
  for (std::size_t i = 0; i < statement.children.size(); ++i) {
    NodeId condition = expressions.matches(statement.values.at(i + 1), tested, *context.scope);
    PathDraft taken = draft;
    require(nodes().both(others, condition), taken, statement.origin);
    bind(statement.values[i + 1], tested, taken);
    write(std::move(taken), withNext(rest, statement.children[i]));
    others = nodes().both(others, nodes().negation(condition));
  }
}

void PathWriter::select(const Statement& statement, const PathDraft& draft,
                        const RestOfPath& rest) {
  const auto& groups = statement.priorityGroups;
  if (!groups.empty() && draft.path.select != 0)
    unsupported("two `unless` on one path", statement.origin);
  const auto select = groups.empty() ? draft.path.select : ++context.selects;
  for (std::size_t i = 0; i < statement.children.size(); ++i) {
    PathDraft taken = draft;
    taken.path.select = select;
    if (!groups.empty())
      taken.path.group = static_cast<std::uint32_t>(
          std::ranges::count_if(groups, [i](auto first) { return first <= i; }));
    write(std::move(taken), withNext(rest, statement.children[i]));
  }
}

void PathWriter::finish(PathDraft draft) {
  if (!draft.ended) unsupported("a path may end without `to`", draft.path.origin);
  if (draft.path.wait && draft.path.port != kNone)
    unsupported("a path with a port cannot wait", draft.path.origin);
  if (nodes().constant(draft.path.guard) == 0) return;
  if (found.size() == kMostPaths)
    unsupported("more than 10000 paths through one `from`", draft.path.origin);
  found.push_back(std::move(draft.path));
}

} // namespace proskill::verify
