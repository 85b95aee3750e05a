#include "bridge/bt/composites.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::bridge::bt {
namespace {

std::size_t guardsOf(const Node& reactive, const Traits& traits) {
  std::size_t count = 0;
  while (count < reactive.children.size() && traits.isPure(reactive.children[count])) ++count;
  return count;
}

} // namespace

bool needsWatching(const Node& reactive, const Traits& traits) {
  const auto guards = guardsOf(reactive, traits);
  const auto running = std::ranges::count_if(
      reactive.children, [&](const Node& child) { return !traits.isPure(child); });
  return running > 1 || (running == 1 && guards > 0);
}

bool isWatching(const Node& node, const Traits& traits) {
  const bool isReactive =
      node.kind == Kind::ReactiveSequence || node.kind == Kind::ReactiveFallback;
  return isReactive && std::ranges::count_if(node.children, [&](const Node& child) {
                         return !traits.isPure(child);
                       }) == 1;
}

std::string Composites::of(const Node& node) {
  auto name = vocabulary.names.take(wordOf(node));
  const auto turn = vocabulary.turn;
  if (!passesTurn(node.kind)) vocabulary.turn.reset();
  auto body = bodyOf(node);
  vocabulary.turn = turn;
  vocabulary.composite(name, vocabulary.comment(node), std::move(body), guard);
  return name;
}

Block Composites::bodyOf(const Node& node) {
  switch (node.kind) {
  case Kind::Timeout: return timeout(node);
  case Kind::Parallel: return parallel(node);
  case Kind::Pipeline: return pipeline(node);
  case Kind::Nonblocking: return nonblocking(node);
  case Kind::PauseResume: return pauseResume(node);
  case Kind::Own: return own(node);
  case Kind::WhileDoElse: return whileDoElse(node);
  case Kind::Switch: return choice(node);
  case Kind::ReactiveSequence:
  case Kind::ReactiveFallback: return reactive(node);
  default: return subTree(node);
  }
}

Block Composites::subTree(const Node& node) {
  Body body(vocabulary);
  body.node(node.children.front(), {}, fail(), maySkip(node.children.front()) ? skipped() : Skip());
  if (traits.ends(node.children.front()).success) append(body.statements, succeed().jump);
  return body.statements;
}

Block Composites::timeout(const Node& node) {
  const auto seconds = secondsIn(node.port("msec"));
  if (!seconds && !node.port("msec").starts_with('{'))
    vocabulary.fail(node, "`msec` must be a number of milliseconds");
  else if (!seconds)
    vocabulary.approximate(node, "`msec` may be any time");
  Body body(vocabulary);
  const auto& child = node.children.front();
  if (seconds == "0") {
    body.node(child, {}, fail()); // no limit
    append(body.statements, succeed().jump);
    return body.statements;
  }
  body.node(child, succeed(), {});
  const Block limit{list("^", seconds.value_or("]0,...["))};
  Block statements{list("race", Form(body.statements), Form(limit))};
  append(statements, fail().jump);
  return statements;
}

Block Composites::whileDoElse(const Node& node) {
  if (!traits.isPure(node.children[0])) {
    vocabulary.fail(node, "a `WhileDoElse` whose condition can run is not supported");
    return fail().jump;
  }
  Guard guard(vocabulary);
  const auto yes = guard.of(node.children[0], false);
  const auto no = guard.of(node.children[0], true);
  Form choice = list("if", yes);
  append(choice.parts, watched(node.children[1], succeed(), fail(), no));
  choice.parts.emplace_back("else");
  append(choice.parts, node.children.size() > 2 ? watched(node.children[2], succeed(), fail(), yes)
                                                : fail().jump);
  const auto again = vocabulary.names.take("again");
  return {list("label", again), choice, list("goto", again)};
}

/// The child, until a condition holds.
Block Composites::watched(const Node& node, const Exit& success, const Exit& failure,
                          const Form& until, const Skip& skip) {
  Body body(vocabulary);
  body.node(node, success, failure, skip);
  if (until == "false") return body.statements;
  return {list("race", Form(body.statements), Form(Block{list("^", until)}))};
}

Block Composites::choice(const Node& node) {
  std::vector<std::string> values;
  for (std::size_t i = 1; i < node.children.size(); ++i)
    values.push_back(fmt::format("Case_{}", i));
  values.emplace_back("Default");
  const auto variable = vocabulary.anyOf((node.name.empty() ? node.id : node.name) + "_value",
                                         values, vocabulary.comment(node));
  vocabulary.approximate(node, "the variable may have any value at any time");
  const auto again = vocabulary.names.take("again");
  Form choice = list("if", list(variable, values[0]));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto here = list(variable, values[i]);
    if (i + 1 == values.size())
      choice.parts.emplace_back("else");
    else if (i > 0)
      append(choice.parts, {"elseif", here});
    append(choice.parts, watched(node.children[i], succeed(), fail(), list("not", here)));
  }
  return {list("label", again), choice, list("goto", again)};
}

Block Composites::reactive(const Node& node) {
  const bool isSequence = node.kind == Kind::ReactiveSequence;
  const auto guards = guardsOf(node, traits);
  const auto early = isSequence ? fail() : succeed();
  const auto late = isSequence ? succeed() : fail();
  Node rest{isSequence ? Kind::Sequence : Kind::Fallback, node.id, node.name, node.place, {}, {}};
  rest.children.assign(node.children.begin() + static_cast<std::ptrdiff_t>(guards),
                       node.children.end());
  const auto goesOn = Guard(vocabulary).ofAll(node, guards, !isSequence, false);
  auto body = isWatching(node, traits) ? onlyOne(rest, early, late) : inTurn(rest, early, late);
  if (goesOn == Form("false")) return early.jump; // no other child is ever ticked
  if (goesOn != Form("true")) guard = goesOn;
  return body;
}

Block Composites::onlyOne(const Node& rest, const Exit& early, const Exit& late) {
  const bool isSequence = rest.kind == Kind::Sequence;
  Body body(vocabulary);
  body.node(rest, isSequence ? late : early, isSequence ? early : late,
            maySkip(rest) ? late : Skip());
  return body.statements;
}

std::vector<std::vector<const Node*>> branchesOf(const Node& node, const Traits& traits) {
  std::vector<std::vector<const Node*>> branches;
  bool isOpen = false;
  for (const auto& child : node.children) {
    if (!isOpen) branches.emplace_back();
    branches.back().push_back(&child);
    isOpen = traits.isPure(child);
  }
  return branches;
}

} // namespace proskill::bridge::bt
