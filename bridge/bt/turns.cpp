#include "bridge/bt/composites.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

/// Reactive nodes of which several children can run. A tick begins with the first of them, which it
/// starts again unless that is running; a child that a tick leaves running halts all others. So a
/// child that runs goes on only if the ones before it end at once.
namespace proskill::bridge::bt {
namespace {

/// Each child that can run, with the conditions that follow it.
std::vector<Node> partsOf(const Node& rest, const Traits& traits) {
  std::vector<Node> parts;
  for (const auto& child : rest.children) {
    if (parts.empty() || !traits.isPure(child))
      parts.push_back({rest.kind, rest.id, rest.name, rest.place, {}, {}});
    parts.back().children.push_back(child);
  }
  return parts;
}

Form becomes(const std::string& variable, const std::string& value) {
  return list(variable, value);
}

bool isNumber(const Node& node, const char* port) { return secondsIn(node.port(port)).has_value(); }

/// Whether nothing in a node runs beside something else.
bool isAlone(const Node& node, const Traits& traits) {
  const bool isReactive =
      node.kind == Kind::ReactiveSequence || node.kind == Kind::ReactiveFallback;
  const auto running = std::ranges::count_if(
      node.children, [&](const Node& child) { return !traits.isPure(child); });
  if (isReactive && running > 1) return false;
  const bool isParallel = node.kind == Kind::Own || node.kind == Kind::Parallel ||
                          node.kind == Kind::ParallelAll || node.kind == Kind::Pipeline ||
                          node.kind == Kind::Nonblocking;
  if (isParallel && running > 1) return false;
  return std::ranges::all_of(node.children,
                             [&](const Node& child) { return isAlone(child, traits); });
}

/// Whether a node becomes statements one after the other, with actions and with waits that take
/// time.
bool isInOrder(const Node& node, const Traits& traits) {
  if (node.ports.contains("_while")) return false;
  if (traits.isPureInside(node)) return true;
  switch (node.kind) {
  case Kind::Action:
  case Kind::Condition:
  case Kind::Script:
  case Kind::AlwaysSuccess:
  case Kind::AlwaysFailure: return true;
  case Kind::Sleep: return isNumber(node, "msec");
  case Kind::Delay: return isNumber(node, "delay_msec") && isInOrder(node.children.front(), traits);
  case Kind::Repeat:
  case Kind::Retry:
    return roundsOf(node).value_or(-1) > 0 && isInOrder(node.children.front(), traits);
  case Kind::Sequence:
  case Kind::SequenceWithMemory:
  case Kind::Fallback:
  case Kind::IfThenElse:
  case Kind::Inverter:
  case Kind::ForceSuccess:
  case Kind::ForceFailure:
  case Kind::KeepRunning:
  case Kind::RunOnce:
  case Kind::Queue:
  case Kind::TryCatch:
  case Kind::Recovery:
    return std::ranges::all_of(node.children,
                               [&](const Node& child) { return isInOrder(child, traits); });
  case Kind::ReactiveSequence:
  case Kind::ReactiveFallback:
  case Kind::Parallel:
  case Kind::ParallelAll:
  case Kind::WhileDoElse:
  case Kind::Switch:
  case Kind::Timeout:
  case Kind::Precondition:
  case Kind::RoundRobin:
  case Kind::Persistent:
  case Kind::Pipeline:
  case Kind::Nonblocking:
  case Kind::PauseResume:
  case Kind::Own:
  case Kind::Rate:
  case Kind::SubTree: return false;
  }
  return false;
}

} // namespace

bool passesTurn(Kind kind) { return kind == Kind::SubTree || kind == Kind::Parallel; }

Block Body::lasting(Form wait) const {
  const auto& marks = vocabulary.marks;
  const auto& turn = vocabulary.turn;
  if (marks.empty() || wait == list("^", "0")) return {std::move(wait)};
  const auto& until = wait.parts.back();
  Block block;
  if (until.word.empty() || until.word.starts_with("[0,")) {  // it may be over at once
    const bool isHaltedByRace = turn && turn->halted.empty(); // so nothing else ends it
    const Block runs{list("set", vocabulary.marksBecome("1")),
                     list("^", isHaltedByRace ? Form("false") : list("=", marks.front(), "0"))};
    block = {list("race", Form(Block{wait}), Form(runs))};
  } else if (turn && !turn->halted.empty()) {
    const auto over = vocabulary.names.take("over");
    block = {list("set", vocabulary.marksBecome("1")),
             list("^", turn->isHalted(), ":timeout", until, list("goto", over)),
             list("goto", turn->halted), list("label", over)};
  } else {
    block = {list("set", vocabulary.marksBecome("1")), std::move(wait)};
  }
  block.push_back(list("set", vocabulary.marksBecome("0")));
  append(block, nextTurn());
  return block;
}

Block Body::lastingAction(const Node& node, const std::string& skill) const {
  Block block{list(skill)};
  const bool isInstant = vocabulary.leaves.of(node.name, node.id).isInstant();
  if (vocabulary.turn && !vocabulary.turn->halted.empty() && !isInstant)
    block.push_back(list("if", list("=", skill + ".status", "failed_inv"),
                         list("goto", vocabulary.turn->halted)));
  append(block, nextTurn());
  return block;
}

Block Body::nextTurn() const {
  const auto& turn = vocabulary.turn;
  if (!turn || turn->child == 1) return {};
  if (turn->halted.empty()) return {list("^", turn->isReached())};
  return {list("^", list("or", turn->isReached(), turn->isHalted())),
          list("if", list("not", turn->isReached()), list("goto", turn->halted))};
}

Block Composites::inTurn(const Node& rest, const Exit& early, const Exit& late) {
  if (maySkip(rest))
    vocabulary.fail(rest, "a reactive node whose children may all be skipped is only supported "
                          "with one child that can run");
  const auto parts = partsOf(rest, traits);
  auto turn = turnOf(rest, parts.size());
  Form branches = list("//");
  bool isReachable = true; // by the ticks after the one that has started it
  for (const auto& part : parts) {
    const auto& child = part.children.front();
    if (!isReachable) vocabulary.approximate(child, "its actions may end although no tick sees it");
    if (!isAlone(part, traits))
      vocabulary.approximate(child, "its parts may end in any order in a tick");
    if (turn.child < parts.size()) startsAgain(child);
    const auto atOnce = traits.endsAtOnce(child);
    isReachable = isReachable && (part.kind == Kind::Sequence ? atOnce.success : atOnce.failure);
    branches.parts.emplace_back(branchInTurn(part, turn, early, late));
    ++turn.child;
  }
  Form start = list(becomes(turn.reached, "0"), becomes(turn.kept, turn.none()));
  for (const auto& runs : turn.runs) start.parts.push_back(becomes(runs, "0"));
  return {list("set", start), branches};
}

/// A child may be a condition, of which the file does not say what it is.
void Composites::startsAgain(const Node& child) {
  if (child.kind == Kind::Action &&
      std::ranges::find(vocabulary.undeclared, child.id) != vocabulary.undeclared.end())
    vocabulary.remarks.push_back(
        {child.place, fmt::format("`{}` starts again at each tick; if it is a condition, a file of "
                                  "`--leaves` may say so",
                                  child.id)});
}

Turn Composites::turnOf(const Node& node, std::size_t children) {
  Turn turn{.reached = {}, .kept = {}, .runs = {}, .halted = {}};
  const auto most = static_cast<std::int64_t>(children) + 1;
  turn.reached = vocabulary.counter(node, "_reached", most);
  turn.kept = vocabulary.counter(node, "_kept", most, most);
  for (std::size_t i = 1; i <= children; ++i)
    turn.runs.push_back(vocabulary.counter(node, fmt::format("_runs_{}", i), 1));
  return turn;
}

Block Composites::branchInTurn(const Node& part, Turn turn, const Exit& early, const Exit& late) {
  const bool isFirst = turn.child == 1;
  const bool inOrder = !isFirst && isInOrder(part, traits);
  if (inOrder) turn.halted = vocabulary.names.take("halted");
  const bool isLast = turn.child == turn.runs.size();
  const auto again = vocabulary.names.take("again");
  const auto once = inTurnOnce(part, turn, early, isLast ? late.jump : passOn(turn));
  Block statements{list("label", again)};
  if (!isFirst) statements.push_back(list("^", turn.isReached()));
  if (isFirst || inOrder)
    append(statements, once);
  else
    statements.push_back(list("race", Form(once), Form(Block{list("^", turn.isHalted())})));
  if (isFirst) append(statements, betweenTicks(turn));
  if (inOrder && !isLast) statements.push_back(list("goto", again));
  if (inOrder) statements.push_back(list("label", turn.halted));
  if (!isFirst) append(statements, forget(turn));
  statements.push_back(list("goto", again));
  return statements;
}

/// The child, the conditions that follow it, and then `after`.
Block Composites::inTurnOnce(const Node& part, const Turn& turn, const Exit& early,
                             const Block& after) {
  const bool isSequence = part.kind == Kind::Sequence;
  const auto next = vocabulary.names.take("next");
  const auto outer = std::exchange(vocabulary.turn, turn);
  vocabulary.marks.push_back(turn.runsHere());
  Body body(vocabulary);
  body.node(part, isSequence ? Exit{} : early, isSequence ? early : Exit{},
            Exit{{list("goto", next)}});
  vocabulary.marks.pop_back();
  vocabulary.turn = outer;
  if (maySkip(part)) body.statements.push_back(list("label", next));
  const auto ends = traits.ends(part);
  if ((isSequence ? ends.success : ends.failure) || maySkip(part)) append(body.statements, after);
  return body.statements;
}

/// A tick that has reached a child that runs on is over. The next one comes at any time.
Block Composites::betweenTicks(const Turn& turn) {
  Form runsOn = list("or", list("=", turn.kept, turn.reached));
  for (std::size_t i = 2; i <= turn.runs.size(); ++i)
    runsOn.parts.push_back(
        list("and", list("=", turn.reached, std::to_string(i)), list("=", turn.runs[i - 1], "1")));
  return {list("^", runsOn, ":effects",
               list(list(turn.kept, turn.reached), becomes(turn.reached, "0"))),
          Body(vocabulary).nextTick(false)};
}

/// The child does not run any more.
Block Composites::forget(const Turn& turn) {
  return {list("set", becomes(turn.runsHere(), "0")),
          list("if", list("=", turn.kept, std::to_string(turn.child)),
               list("set", becomes(turn.kept, turn.none())))};
}

/// The tick goes on with the next child.
Block Composites::passOn(const Turn& turn) {
  const auto next = becomes(turn.reached, std::to_string(turn.child + 1));
  const auto stops = becomes(turn.runsHere(), "0");
  if (turn.child == 1) return {list("set", list(next, stops))};
  return {list("if", list("=", turn.kept, std::to_string(turn.child)),
               list("set", list(next, stops, becomes(turn.kept, turn.none()))), "else",
               list("set", list(next, stops)))};
}

} // namespace proskill::bridge::bt
