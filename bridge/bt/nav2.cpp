#include "bridge/bt/composites.h"

#include <fmt/format.h>

/// The nodes of Nav2 that control others.
namespace proskill::bridge::bt {

/// After a failure of the first child the second one is ticked, and then the first one again, a
/// number of times.
void Body::recovery(const Node& node, const Exit& success, const Exit& failure) {
  const auto retries = retriesOf(node);
  if (!retries || *retries < 0 || *retries > 1'000'000)
    return vocabulary.fail(node, "`number_of_retries` must be a number from 0 to 1,000,000");
  if (*retries == 0 || !traits.ends(node.children[0]).failure)
    return this->node(node.children[0], success, failure);
  const auto at = statements.size();
  const auto again = vocabulary.names.take("again");
  const auto recover = vocabulary.names.take("recover");
  const auto end = success.next() || failure.next() ? vocabulary.names.take("done") : std::string();
  const auto yes = orTo(success, end);
  const auto no = orTo(failure, end);
  const auto count = vocabulary.counter(node, "_retries", *retries);
  statements.push_back(list("set", list(count, "0")));
  place(again);
  this->node(node.children[0], yes, to(recover));
  placeUsed(recover);
  test(list(">=", count, std::to_string(*retries)), no);
  this->node(node.children[1], {}, no);
  statements.push_back(list("set", list(count, list("+", count, "1"))));
  leave(to(again));
  placeUsed(end);
  commentAt(at, node);
}

/// The child that comes next depends on what has happened before the node was last halted, or on
/// the blackboard. Where it is a sequence, a child that has succeeded is followed by another one.
void Body::anyOrder(const Node& node, bool isSequence, const Exit& success, const Exit& failure) {
  const auto at = statements.size();
  vocabulary.approximate(node, "its children may be tried in any order, any number of times");
  std::vector<std::string> values;
  for (std::size_t i = 0; i < node.children.size(); ++i)
    values.push_back(fmt::format("Child_{}", i + 1));
  const bool runsOut = isSequence || traits.endsInside(node).failure;
  if (runsOut) values.emplace_back("None");
  const auto next = vocabulary.anyOf(wordOf(node) + "_next", values, vocabulary.comment(node));
  const auto again = vocabulary.names.take("again");
  const auto end = success.next() || failure.next() ? vocabulary.names.take("done") : std::string();
  place(again);
  append(statements, lasting(list("^", "[0,...[")));
  const auto& last = isSequence ? success : failure;
  const auto early = orTo(isSequence ? failure : success, end);
  if (runsOut) test(list(next, "None"), orTo(last, end));
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    Body child(vocabulary);
    child.node(node.children[i], isSequence ? to(again) : early, isSequence ? early : to(again),
               isSequence ? to(again) : Skip());
    Form step = list("if", list(next, values[i]));
    append(step.parts, child.statements);
    statements.push_back(std::move(step));
  }
  leave(to(again));
  placeUsed(end);
  commentAt(at, node);
}

void Body::rate(const Node& node, const Exit& success, const Exit& failure, const Skip& skip) {
  vocabulary.approximate(node, "its child may be ticked at any time");
  Form wait = list("^", "[0,...[");
  wait.comment = vocabulary.comment(node);
  append(statements, lasting(std::move(wait)));
  this->node(node.children.front(), success, failure, skip);
}

/// A child runs again and again. From its first success on, the following ones run beside it.
Block Composites::pipeline(const Node& node) {
  const auto parts = pipelineParts(node);
  Body body(vocabulary);
  if (parts.empty()) {
    body.node(node.children.front(), succeed(), fail());
    return body.statements;
  }
  vocabulary.approximate(node, "a child that has succeeded is ticked again at any time");
  const auto all = std::to_string(parts.size());
  const auto passed = vocabulary.counter(node, "_passed", static_cast<std::int64_t>(parts.size()));
  Form branches = list("//");
  for (std::size_t i = 0; i < parts.size(); ++i)
    branches.parts.emplace_back(pipelineBranch(parts[i], i, passed));
  Block end{list("^", list("=", passed, all))};
  body.node(node.children.back(), succeed(), fail());
  append(end, body.statements);
  branches.parts.emplace_back(std::move(end));
  return {list("set", list(passed, "0")), branches};
}

/// The children but the last one. A tick goes through those that always end in it one after the
/// other, so they are one part.
std::vector<std::span<const Node>> Composites::pipelineParts(const Node& node) const {
  const auto children = std::span(node.children).first(node.children.size() - 1);
  std::vector<std::span<const Node>> parts;
  for (std::size_t i = 0; i < children.size(); ++i) {
    const bool goesOn = i > 0 && traits.isInstant(children[i - 1]) && traits.isInstant(children[i]);
    if (!goesOn) parts.push_back(children.subspan(i, 0));
    parts.back() = {parts.back().data(), parts.back().size() + 1};
  }
  return parts;
}

Block Composites::pipelineBranch(std::span<const Node> part, std::size_t place,
                                 const std::string& passed) {
  Body body(vocabulary);
  if (place > 0) body.statements.push_back(list("^", list(">=", passed, std::to_string(place))));
  const auto again = vocabulary.names.take("again");
  body.statements.push_back(list("label", again));
  for (const auto& child : part) body.node(child, {}, fail());
  body.statements.push_back(list("if", list("=", passed, std::to_string(place)),
                                 list("set", list(passed, std::to_string(place + 1)))));
  append(body.statements, {body.nextTick(true), list("goto", again)});
  return body.statements;
}

/// All children are ticked at each tick, also those that have succeeded, until all succeed at once.
Block Composites::nonblocking(const Node& node) {
  vocabulary.approximate(node, "it may succeed as soon as each child has succeeded once");
  Block statements;
  Form branches = list("//");
  Form all = list("and");
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const auto passed = vocabulary.counter(node, fmt::format("_passed_{}", i + 1), 1);
    const auto again = vocabulary.names.take("again");
    Body body(vocabulary);
    body.statements.push_back(list("label", again));
    body.node(node.children[i], {}, fail());
    append(body.statements,
           {list("set", list(passed, "1")), body.nextTick(true), list("goto", again)});
    statements.push_back(list("set", list(passed, "0")));
    branches.parts.emplace_back(std::move(body.statements));
    all.parts.push_back(list("=", passed, "1"));
  }
  Block end{list("^", all.parts.size() > 2 ? all : all.parts.back()), list("^", "[0,...[")};
  append(end, succeed().jump);
  branches.parts.emplace_back(std::move(end));
  statements.push_back(std::move(branches));
  return statements;
}

/// The first child runs unless the node is paused; the others before, during and after a pause.
Block Composites::pauseResume(const Node& node) {
  vocabulary.approximate(node, "it may be paused and resumed at any time, in any order");
  std::vector<std::string> values{"Resumed"};
  for (std::size_t i = 1; i < node.children.size(); ++i)
    values.push_back(fmt::format("Paused_{}", i));
  values.emplace_back("Waiting");
  const auto variable = vocabulary.anyOf(wordOf(node) + "_state", values, vocabulary.comment(node));
  const auto again = vocabulary.names.take("again");
  Form choice = list("if", list(variable, values[0]));
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const auto here = list(variable, values[i]);
    if (i > 0) append(choice.parts, {"elseif", here});
    append(choice.parts, watched(node.children[i], i == 0 ? succeed() : Exit(), fail(),
                                 list("not", here), i == 0 ? succeed() : Skip()));
  }
  append(choice.parts, {"else", list("^", list("not", list(variable, values.back())))});
  return {list("label", again), choice, Body(vocabulary).nextTick(true), list("goto", again)};
}

} // namespace proskill::bridge::bt
