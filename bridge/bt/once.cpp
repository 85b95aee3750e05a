#include "bridge/bt/composites.h"

#include <fmt/format.h>

/// What decides whether a child starts, and how often.
namespace proskill::bridge::bt {

/// The script is tested before the node starts, and while it runs.
void Body::whileTrue(const Node& node, const Exit& success, const Exit& failure, const Exit& skip) {
  const auto variable =
      vocabulary.anyOf(wordOf(node) + "_while", {"No", "Yes"}, vocabulary.comment(node));
  vocabulary.approximate(node, "the script of `_while` may have any result at any time");
  test(list(variable, "No"), skip);
  if (traits.isPureInside(node)) return plain(node, success, failure, skip);
  const auto skill = Composites(vocabulary).whileTrue(node, list(variable, "No"));
  const auto at = statements.size();
  statements.push_back(list(skill));
  append(statements, nextTurn());
  called(skill, traits.endsInside(node), success, failure, skip);
  commentAt(at, node);
}

std::string Composites::whileTrue(const Node& node, const Form& until) {
  const auto turn = std::exchange(vocabulary.turn, std::nullopt);
  Body body(vocabulary);
  body.plain(node, succeed(), fail(), skipped());
  vocabulary.turn = turn;
  Block statements{list("race", Form(body.statements), Form(Block{list("^", until)}))};
  append(statements, skipped().jump);
  auto name = vocabulary.names.take(wordOf(node));
  vocabulary.composite(name, vocabulary.comment(node), std::move(statements));
  return name;
}

/// A number says how the child has ended: 0 not yet, 1 with a success, 2 with a failure.
void Body::runOnce(const Node& node, const Exit& success, const Exit& failure, const Skip& skip) {
  const auto skips = thenSkips(node);
  if (!skips) return vocabulary.fail(node, "`then_skip` must be `true` or `false`");
  if (!vocabulary.isRepeated) return this->node(node.children.front(), success, failure, skip);
  const auto at = statements.size();
  const auto ended = vocabulary.counter(node, "_ended", 2);
  const auto end = vocabulary.names.take("done");
  const auto failed = vocabulary.names.take("failed");
  const auto yes = orTo(success, end);
  const auto no = orTo(failure, end);
  if (*skips) test(list(">", ended, "0"), *skip);
  if (!*skips) test(list("=", ended, "1"), yes);
  if (!*skips) test(list("=", ended, "2"), no);
  this->node(node.children.front(), {}, to(failed), skip);
  const bool succeeds = traits.ends(node.children.front()).success;
  const bool fails = jumpsTo(failed);
  if (succeeds) statements.push_back(list("set", list(ended, "1")));
  if (succeeds) leave(fails ? yes : success);
  if (fails) append(statements, {list("label", failed), list("set", list(ended, "2"))});
  if (fails) leave(failure);
  placeUsed(end);
  commentAt(at, node);
}

void Body::precondition(const Node& node, const Exit& success, const Exit& failure,
                        const Skip& skip) {
  const auto otherwise = otherwiseOf(node);
  if (!otherwise)
    return vocabulary.fail(node, "`else` must be SUCCESS, FAILURE, SKIPPED or RUNNING");
  const auto variable =
      vocabulary.anyOf(wordOf(node) + "_if", {"No", "Yes"}, vocabulary.comment(node));
  vocabulary.approximate(node, fmt::format("the test of `{}` may have any result", node.id));
  const auto end = vocabulary.names.take("done");
  const auto at = statements.size();
  switch (*otherwise) {
  case Otherwise::Success: test(list(variable, "No"), orTo(success, end)); break;
  case Otherwise::Failure: test(list(variable, "No"), orTo(failure, end)); break;
  case Otherwise::Skipped: test(list(variable, "No"), *skip); break;
  case Otherwise::Running: append(statements, lasting(list("^", list(variable, "Yes")))); break;
  }
  this->node(node.children.front(), success, failure, skip);
  placeUsed(end);
  commentAt(at, node);
}

/// Nothing is known of a node that the author of the tree has programmed, but that it halts its
/// children before it ends. What it decides comes as events.
Block Composites::own(const Node& node) {
  vocabulary.approximate(node, "it may tick and halt its children at any time, and end at any time "
                               "with any result");
  const auto result = vocabulary.anyOf(wordOf(node) + "_result", {"None", "Success", "Failure"},
                                       vocabulary.comment(node));
  Form branches = list("//");
  for (std::size_t i = 0; i < node.children.size(); ++i)
    branches.parts.emplace_back(
        tickedAndHalted(node.children[i], fmt::format("{}_child_{}", wordOf(node), i + 1)));
  Form end = list("if", list(result, "Success"));
  append(end.parts, succeed().jump);
  const auto none = list(result, "None");
  Block ends{list("^", none), list("^", list("not", none)), end}; // not with the last result
  append(ends, fail().jump);
  branches.parts.emplace_back(std::move(ends));
  return {branches};
}

Block Composites::tickedAndHalted(const Node& child, const std::string& wish) {
  const auto state = vocabulary.anyOf(wish, {"Halted", "Ticked"}, vocabulary.comment(child));
  const auto isHalted = list("^", list(state, "Halted"));
  const auto again = vocabulary.names.take("again");
  const auto skips = vocabulary.names.take("skipped");
  Body body(vocabulary);
  body.node(child, {}, {}, Exit{{list("goto", skips)}});
  if (maySkip(child)) body.statements.push_back(list("label", skips));
  return {list("label", again), list("^", list(state, "Ticked")),
          list("race", Form(body.statements), Form(Block{isHalted})), isHalted,
          list("goto", again)};
}

/// A round for each element, and a tick between two of them.
void Body::queue(const Node& node, const Exit& success, const Exit& failure, const Skip& skip) {
  const auto otherwise = otherwiseOf(node);
  if (!otherwise) return vocabulary.fail(node, "`if_empty` must be SUCCESS, FAILURE or SKIPPED");
  const auto at = statements.size();
  const auto again = vocabulary.names.take("again");
  const auto empty = vocabulary.names.take("empty");
  const auto end = vocabulary.names.take("done");
  const auto elements = elementsIn(node);
  const auto counted = elements ? vocabulary.counter(node, "_count", *elements)
                                : vocabulary.anyOf(wordOf(node) + "_queue", {"Full", "Empty"},
                                                   vocabulary.comment(node));
  if (!elements) vocabulary.approximate(node, "the queue may have any number of elements");
  if (elements) statements.push_back(list("set", list(counted, "0")));
  place(again);
  test(elements ? list(">=", counted, std::to_string(*elements)) : list(counted, "Empty"),
       to(empty));
  const auto round = vocabulary.names.take("next");
  this->node(node.children.front(), {}, orTo(failure, end), to(round));
  placeUsed(round);
  if (elements) statements.push_back(list("set", list(counted, list("+", counted, "1"))));
  append(statements, lasting(nextTick(false)));
  leave(to(again));
  place(empty);
  leave(*otherwise == Otherwise::Success   ? success
        : *otherwise == Otherwise::Failure ? failure
                                           : *skip);
  placeUsed(end);
  commentAt(at, node);
}

/// All children but the last are a sequence; if it fails, the last one is run, and the node fails.
void Body::tryCatch(const Node& node, const Exit& success, const Exit& failure, const Skip& skip) {
  const auto onHalt = node.port("catch_on_halt", "false");
  if (onHalt != "false" && onHalt != "0")
    return vocabulary.fail(node, "`catch_on_halt` is not supported");
  Node tried{Kind::Sequence, node.id, node.name, node.place, {}, {}};
  tried.children.assign(node.children.begin(), node.children.end() - 1);
  const auto caught = vocabulary.names.take("caught");
  const auto end = vocabulary.names.take("done");
  const auto no = orTo(failure, end);
  inOrder(tried, true, orTo(success, end), to(caught), skip);
  placeUsed(caught);
  this->node(node.children.back(), no, no, no);
  placeUsed(end);
}

} // namespace proskill::bridge::bt
