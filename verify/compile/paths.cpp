#include "verify/compile/paths.h"

#include "verify/compile/unsupported.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace proskill::verify {

using fiacre::Statement;
using fiacre::StatementKind;

namespace {

bool isTimed(const fiacre::Interval& interval) {
  bool immediate = interval.upper == 0 && !interval.lowerOpen && !interval.upperOpen;
  bool always = interval.lower == 0 && !interval.lowerOpen && !interval.upper;
  return !immediate && !always;
}

/// Whether a statement only handles data and ends paths.
bool isPlain(const Statement& statement) {
  switch (statement.kind) {
  case StatementKind::Null:
  case StatementKind::Comment:
  case StatementKind::Assign:
  case StatementKind::Tag:
  case StatementKind::To:
  case StatementKind::Loop: return true;
  case StatementKind::If:
  case StatementKind::Case:
  case StatementKind::While:
  case StatementKind::Sequence: return std::ranges::all_of(statement.children, isPlain);
  case StatementKind::Any:
  case StatementKind::On:
  case StatementKind::Wait:
  case StatementKind::Select:
  case StatementKind::Send:
  case StatementKind::Receive:
  case StatementKind::Start:
  case StatementKind::Sync:
  case StatementKind::Foreach:
  case StatementKind::Return: return false;
  }
  std::unreachable();
}

bool endsPath(const Statement& statement) {
  if (statement.kind == StatementKind::To || statement.kind == StatementKind::Loop) return true;
  return std::ranges::any_of(statement.children, endsPath);
}

constexpr std::size_t kMostChoices = 4096;
constexpr std::size_t kMostPaths = 10'000; // of one `from`
constexpr std::size_t kMostCode = 100'000; // of one path

/// Statements still to come; the next is last.
using Rest = std::vector<const Statement*>;

/// A path that is being written.
struct Draft {
  Path path;
  bool assigned = false;            ///< an `on` is no guard any more
  bool branched = false;            ///< what cells hold is known no more
  std::map<CellId, NodeId> current; ///< what assignments have put into cells, over the state before
  bool ended = false;               ///< by `to` or `loop`
};

class Writer {
public:
  Writer(PathContext& of, Expressions& in) : context(of), expressions(in) {}

  void write(Draft draft, Rest rest);
  std::vector<Path> found;

private:
  bool step(const Statement& statement, Draft& draft, Rest& rest);
  void code(const Statement& statement, Draft& draft, Rest rest);
  void codeAll(Draft& draft, Rest rest);
  void codeIf(const Statement& statement, Draft& draft, const Rest& rest);
  void codeCase(const Statement& statement, Draft& draft, const Rest& rest);
  void codeChoice(NodeId condition, Draft& draft, const Rest& then, const Rest& otherwise);
  void require(NodeId condition, Draft& draft, fiacre::OriginId origin);
  void codeWhile(const Statement& statement, Draft& draft);
  void assign(const Statement& statement, Draft& draft);
  void end(const Statement& statement, Draft& draft);
  void synchronise(const Statement& statement, Draft& draft);
  [[nodiscard]] NodeId beforePath(NodeId value, const Draft& draft);
  void splitIf(const Statement& statement, const Draft& draft, const Rest& rest);
  void splitCase(const Statement& statement, const Draft& draft, const Rest& rest);
  void select(const Statement& statement, const Draft& draft, const Rest& rest);
  void bind(const fiacre::Expr& pattern, const Value& tested, Draft& draft);
  void any(const Statement& statement, const Draft& draft, const Rest& rest);
  void foreach (const Statement& statement, Rest & rest);
  void send(const Statement& statement, Draft& draft);
  void receive(const Statement& statement, Draft& draft);
  void addAssignments(Draft& draft, std::uint32_t first);
  void finish(Draft draft);

  Nodes& nodes() { return expressions.nodes(); }
  NodeId scalar(const fiacre::Expr& expr) { return expressions.scalar(expr, *context.scope); }

  PathContext& context;
  Expressions& expressions;
};

Instruction& emit(Draft& draft, InstructionKind kind) {
  draft.path.code.push_back({.kind = kind});
  return draft.path.code.back();
}

void noteOrigin(const Statement& statement, Draft& draft) {
  if (statement.origin == 0) return;
  emit(draft, InstructionKind::Origin).first = statement.origin;
  if (draft.path.origin == 0) draft.path.origin = statement.origin;
}

Rest with(Rest rest, const Statement& next) {
  rest.push_back(&next);
  return rest;
}

void Writer::write(Draft draft, Rest rest) {
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
      bool plain = isPlain(statement);
      if (plain && endsPath(statement))
        plain = std::ranges::all_of(rest, [](const auto* next) { return isPlain(*next); });
      if (plain) {
        if (!endsPath(statement)) {
          codeAll(draft, {&statement});
          continue;
        }
        codeAll(draft, with(std::move(rest), statement));
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

/// A statement that does not branch. False: no path goes on from here.
bool Writer::step(const Statement& statement, Draft& draft, Rest& rest) {
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
    emit(draft, InstructionKind::Tag).event = context.tag(statement.name);
    return true;
  case StatementKind::Any:
  case StatementKind::If:
  case StatementKind::Case:
  case StatementKind::Select:
  case StatementKind::Start:
  case StatementKind::Sync:
  case StatementKind::While:
  case StatementKind::Return: unsupported("a statement that is not verified yet", statement.origin);
  }
  std::unreachable();
}

void Writer::require(NodeId condition, Draft& draft, fiacre::OriginId origin) {
  if (!draft.assigned) {
    if (expressions.mayFail(condition))
      draft.path.risks.push_back(
          {nodes().both(draft.path.guard, nodes().fails(condition)), condition, origin});
    draft.path.guard = nodes().both(draft.path.guard, condition);
    return;
  }
  emit(draft, InstructionKind::On).node = condition;
  draft.path.tentative = true;
}

void Writer::assign(const Statement& statement, Draft& draft) {
  auto first = static_cast<std::uint32_t>(draft.path.assignments.size());
  for (std::size_t i = 0; i < statement.targets.size(); ++i) {
    const auto& type = expressions.typeOf(statement.targets[i], *context.scope);
    Value source = expressions.value(statement.values.at(i), *context.scope, &type);
    expressions.assign(statement.targets[i], source, *context.scope, draft.path.assignments, first);
  }
  addAssignments(draft, first);
}

/// Those from `first` on happen at once.
void Writer::addAssignments(Draft& draft, std::uint32_t first) {
  auto& instruction = emit(draft, InstructionKind::Assign);
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

/// A value within the path, over the state before it.
NodeId Writer::beforePath(NodeId value, const Draft& draft) {
  return nodes().substitute(value, [&](const Node& leaf) -> std::optional<NodeId> {
    if (leaf.op != NodeOp::Cell) return std::nullopt;
    const auto known = draft.current.find(leaf.a);
    return known == draft.current.end() ? std::nullopt : std::optional(known->second);
  });
}

void Writer::send(const Statement& statement, Draft& draft) {
  synchronise(statement, draft);
  if (!statement.values.empty() && draft.branched)
    unsupported("a value is sent behind a choice on the same path", statement.origin);
  const auto& types = context.valuesOf(statement.name);
  for (std::size_t i = 0; i < statement.values.size(); ++i) {
    const auto* type = i < types.size() ? &types[i] : nullptr;
    Value sent = expressions.value(statement.values[i], *context.scope, type);
    if (type) sent = expressions.fitted(std::move(sent), *type, "what goes over the port");
    for (auto part : sent.parts) {
      draft.path.sent.push_back(beforePath(part, draft));
      if (expressions.mayFail(part)) // the sender's fault, whoever takes it
        emit(draft, InstructionKind::On).node = nodes().equal(part, part);
    }
  }
}

/// What comes is assigned first, and `where` looks at it then.
void Writer::receive(const Statement& statement, Draft& draft) {
  synchronise(statement, draft);
  const auto first = static_cast<std::uint32_t>(draft.path.assignments.size());
  std::uint32_t part = 0;
  for (const auto& target : statement.targets) {
    Value source = expressions.lowest(expressions.typeOf(target, *context.scope));
    for (auto& each : source.parts) each = nodes().received(part++);
    expressions.assign(target, source, *context.scope, draft.path.assignments, first);
  }
  draft.path.receives = true;
  addAssignments(draft, first);
  for (const auto& condition : statement.values)
    require(scalar(condition), draft, statement.origin);
}

/// A path for each value.
void Writer::any(const Statement& statement, const Draft& draft, const Rest& rest) {
  std::vector<Draft> all{draft};
  for (const auto& target : statement.targets) {
    const auto values = expressions.allValues(expressions.typeOf(target, *context.scope));
    std::vector<Draft> longer;
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

void Writer::foreach (const Statement& statement, Rest & rest) {
  const fiacre::Expr variable{.kind = fiacre::ExprKind::Name, .name = statement.name};
  const auto all = expressions.allValues(expressions.typeOf(variable, *context.scope));
  for (auto turn = all.high; turn >= all.low; --turn) {
    rest.push_back(&statement.children.at(0));
    rest.push_back(&expressions.assignmentOf(variable, turn));
  }
}

void Writer::synchronise(const Statement& statement, Draft& draft) {
  if (draft.path.port != kNone) unsupported("two ports on one path", statement.origin);
  auto port = context.ports.find(statement.name);
  if (port == context.ports.end())
    unsupported("`" + statement.name + "` is no port of this process", statement.origin);
  draft.path.port = port->second;
}

void Writer::end(const Statement& statement, Draft& draft) {
  draft.ended = true;
  if (statement.kind == StatementKind::Loop) {
    emit(draft, InstructionKind::Loop).leaf = context.nextLeaf++;
    return;
  }
  const auto& states = context.process->states;
  auto state = std::ranges::find(states, statement.name, &fiacre::State::name);
  if (state == states.end())
    unsupported("`" + statement.name + "` is no state of this process", statement.origin);
  auto number = static_cast<std::uint32_t>(state - states.begin());
  auto& instruction = emit(draft, InstructionKind::To);
  instruction.first = static_cast<std::uint32_t>(draft.path.assignments.size());
  instruction.last = number;
  instruction.event = context.entering(number);
  instruction.leaf = context.nextLeaf++;
  draft.path.assignments.push_back({context.location, nodes().number(number), false});
}

/// Statements that are all plain, to their end.
void Writer::codeAll(Draft& draft, Rest rest) {
  while (!rest.empty() && !draft.ended) {
    const Statement& statement = *rest.back();
    rest.pop_back();
    if (draft.path.code.size() > kMostCode)
      unsupported("too many choices, one after the other", statement.origin);
    if (statement.kind == StatementKind::If || statement.kind == StatementKind::Case) {
      noteOrigin(statement, draft);
      auto inner = endsPath(statement) ? std::exchange(rest, {}) : Rest{};
      statement.kind == StatementKind::If ? codeIf(statement, draft, inner)
                                          : codeCase(statement, draft, inner);
    } else if (statement.kind == StatementKind::While) {
      noteOrigin(statement, draft);
      codeWhile(statement, draft);
    } else {
      step(statement, draft, rest);
    }
  }
}

/// The code of two sides; each is the whole of what is to come on it.
void Writer::codeChoice(NodeId condition, Draft& draft, const Rest& then, const Rest& otherwise) {
  draft.branched = true;
  const auto branch = draft.path.code.size();
  emit(draft, InstructionKind::JumpUnless).node = condition;
  codeAll(draft, then);
  const bool thenEnded = std::exchange(draft.ended, false);
  const auto jump = draft.path.code.size();
  if (!thenEnded) emit(draft, InstructionKind::Jump);
  draft.path.code[branch].last = static_cast<std::uint32_t>(draft.path.code.size());
  codeAll(draft, otherwise);
  if (!thenEnded) draft.path.code[jump].last = static_cast<std::uint32_t>(draft.path.code.size());
  draft.ended = draft.ended && thenEnded;
  draft.assigned = true;
}

void Writer::codeWhile(const Statement& statement, Draft& draft) {
  if (endsPath(statement)) unsupported("`to` or `loop` within a `while`", statement.origin);
  const auto again = static_cast<std::uint32_t>(draft.path.code.size());
  const NodeId condition = scalar(statement.values.at(0));
  emit(draft, InstructionKind::JumpUnless).node = condition;
  draft.branched = draft.assigned = true;
  codeAll(draft, {&statement.children.at(0)});
  emit(draft, InstructionKind::Jump).last = again;
  draft.path.code[again].last = static_cast<std::uint32_t>(draft.path.code.size());
}

void Writer::codeIf(const Statement& statement, Draft& draft, const Rest& rest) {
  NodeId condition = scalar(statement.values.at(0));
  Rest otherwise = statement.children.size() > 1 ? with(rest, statement.children[1]) : rest;
  if (auto known = nodes().constant(condition))
    return codeAll(draft, *known != 0 ? with(rest, statement.children.at(0)) : otherwise);
  codeChoice(condition, draft, with(rest, statement.children.at(0)), otherwise);
}

void Writer::codeCase(const Statement& statement, Draft& draft, const Rest& rest) {
  draft.branched = true;
  Value tested = expressions.value(statement.values.at(0), *context.scope);
  std::vector<std::size_t> jumps;
  bool allEnded = true;
  for (std::size_t i = 0; i < statement.children.size(); ++i) {
    NodeId condition = expressions.matches(statement.values.at(i + 1), tested, *context.scope);
    const auto branch = draft.path.code.size();
    emit(draft, InstructionKind::JumpUnless).node = condition;
    bind(statement.values[i + 1], tested, draft);
    codeAll(draft, with(rest, statement.children[i]));
    if (!std::exchange(draft.ended, false)) {
      allEnded = false;
      jumps.push_back(draft.path.code.size());
      emit(draft, InstructionKind::Jump);
    }
    draft.path.code[branch].last = static_cast<std::uint32_t>(draft.path.code.size());
  }
  emit(draft, InstructionKind::On).node = nodes().number(0); // no pattern matches
  draft.path.tentative = true;
  for (auto jump : jumps)
    draft.path.code[jump].last = static_cast<std::uint32_t>(draft.path.code.size());
  draft.ended = allEnded;
  draft.assigned = true;
}

/// Gives the variables of a pattern their values.
void Writer::bind(const fiacre::Expr& pattern, const Value& tested, Draft& draft) {
  const auto all = expressions.bindings(pattern, tested, *context.scope);
  if (all.empty()) return;
  const auto first = static_cast<std::uint32_t>(draft.path.assignments.size());
  for (const auto& [variable, value] : all)
    expressions.assign(variable, value, *context.scope, draft.path.assignments, first);
  addAssignments(draft, first);
}

void Writer::splitIf(const Statement& statement, const Draft& draft, const Rest& rest) {
  NodeId condition = scalar(statement.values.at(0));
  const auto take = [&](NodeId guard, const Rest& next) {
    if (nodes().constant(guard) == 0) return;
    Draft taken = draft;
    require(guard, taken, statement.origin);
    write(std::move(taken), next);
  };
  take(condition, with(rest, statement.children.at(0)));
  take(nodes().negation(condition),
       statement.children.size() > 1 ? with(rest, statement.children[1]) : rest);
}

void Writer::splitCase(const Statement& statement, const Draft& draft, const Rest& rest) {
  Value tested = expressions.value(statement.values.at(0), *context.scope);
  NodeId others = nodes().number(1);
  for (std::size_t i = 0; i < statement.children.size(); ++i) {
    NodeId condition = expressions.matches(statement.values.at(i + 1), tested, *context.scope);
    Draft taken = draft;
    require(nodes().both(others, condition), taken, statement.origin);
    bind(statement.values[i + 1], tested, taken);
    write(std::move(taken), with(rest, statement.children[i]));
    others = nodes().both(others, nodes().negation(condition));
  }
}

void Writer::select(const Statement& statement, const Draft& draft, const Rest& rest) {
  const auto& groups = statement.priorityGroups;
  if (!groups.empty() && draft.path.select != 0)
    unsupported("two `unless` on one path", statement.origin);
  const auto select = groups.empty() ? draft.path.select : ++context.selects;
  for (std::size_t i = 0; i < statement.children.size(); ++i) {
    Draft taken = draft;
    taken.path.select = select;
    if (!groups.empty())
      taken.path.group = static_cast<std::uint32_t>(
          std::ranges::count_if(groups, [i](auto first) { return first <= i; }));
    write(std::move(taken), with(rest, statement.children[i]));
  }
}

void Writer::finish(Draft draft) {
  if (!draft.ended) unsupported("a path may end without `to`", draft.path.origin);
  if (draft.path.wait && draft.path.port != kNone)
    unsupported("a path with a port cannot wait", draft.path.origin);
  if (nodes().constant(draft.path.guard) == 0) return;
  if (found.size() == kMostPaths)
    unsupported("more than 10000 paths through one `from`", draft.path.origin);
  found.push_back(std::move(draft.path));
}

/// What a path is split by when it waits: where it ends, `kNone` for `loop`.
std::set<std::uint32_t> endsOf(const Path& path) {
  std::set<std::uint32_t> ends;
  for (const auto& instruction : path.code) {
    if (instruction.kind == InstructionKind::To) ends.insert(instruction.last);
    if (instruction.kind == InstructionKind::Loop) ends.insert(kNone);
  }
  return ends;
}

/// The path with every end outside of `kept` turned into giving up.
Path restricted(Path path, const std::set<std::uint32_t>& kept, NodeId never) {
  for (auto& instruction : path.code) {
    bool to = instruction.kind == InstructionKind::To;
    bool loop = instruction.kind == InstructionKind::Loop;
    if ((!to && !loop) || kept.contains(to ? instruction.last : kNone)) continue;
    instruction = {.kind = InstructionKind::On, .node = never};
    path.tentative = true;
  }
  path.loops = kept.contains(kNone);
  return path;
}

} // namespace

const std::vector<fiacre::Type>& PathContext::valuesOf(const std::string& port) const {
  static const std::vector<fiacre::Type> kNothing;
  const auto found = std::ranges::find(process->ports, port, &fiacre::Port::name);
  return found == process->ports.end() ? kNothing : found->values;
}

std::vector<Path> pathsOf(const fiacre::From& from, std::uint32_t location, PathContext& context,
                          Expressions& expressions) {
  Writer writer(context, expressions);
  Draft draft;
  draft.path.instance = context.instance;
  draft.path.location = location;
  draft.path.guard = expressions.nodes().number(1);
  writer.write(std::move(draft), {&from.statement});
  const NodeId never = expressions.nodes().number(0);
  std::vector<Path> all;
  for (const auto& path : writer.found) {
    bool timed = path.port != kNone ? context.portIsTimed[path.port]
                                    : isTimed(path.wait.value_or(fiacre::Interval{}));
    std::set<std::uint32_t> moves = endsOf(path);
    const bool loops = moves.erase(kNone) > 0;
    if (loops) all.push_back(restricted(path, {kNone}, never));
    if (timed)
      for (auto end : moves) all.push_back(restricted(path, {end}, never));
    else if (!moves.empty())
      all.push_back(restricted(path, moves, never));
  }
  return all;
}

} // namespace proskill::verify
