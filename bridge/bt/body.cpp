#include "bridge/bt/body.h"

#include "bridge/bt/composites.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::bridge::bt {

Exit succeed() { return {{list("success", "done")}}; }
Exit fail() { return {{list("failure", "failed")}}; }
Exit Body::to(const std::string& label) { return {{list("goto", label)}}; }
Exit Body::orTo(const Exit& exit, const std::string& label) {
  return exit.next() ? to(label) : exit;
}

std::optional<std::string> secondsIn(const std::string& port) {
  const auto milliseconds = numberIn(port);
  if (!milliseconds || *milliseconds < 0 || *milliseconds > 1'000'000'000) return std::nullopt;
  auto text = fmt::format("{}.{:03}", *milliseconds / 1000, *milliseconds % 1000);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

void Body::node(const Node& node, const Exit& success, const Exit& failure) {
  for (const auto* port : {"_skipIf", "_while"})
    if (node.ports.contains(port))
      vocabulary.fail(node, fmt::format("`{}` is not supported", port));
  if (!hasPrecondition(node)) return plain(node, success, failure);
  const auto done = vocabulary.names.take("done");
  const auto yes = orTo(success, done);
  const auto no = orTo(failure, done);
  preconditions(node, yes, no);
  plain(node, success, failure);
  placeUsed(done);
}

void Body::preconditions(const Node& node, const Exit& success, const Exit& failure) {
  scripted(node, "_failureIf", failure);
  scripted(node, "_successIf", success);
}

void Body::scripted(const Node& node, const std::string& port, const Exit& exit) {
  if (!node.ports.contains(port)) return;
  const auto variable = vocabulary.anyOf((node.name.empty() ? node.id : node.name) + port,
                                         {"No", "Yes"}, vocabulary.comment(node));
  vocabulary.approximate(node, fmt::format("the script of `{}` may have any result", port));
  const auto at = statements.size();
  test(list(variable, "Yes"), exit);
  commentAt(at, node);
}

void Body::plain(const Node& node, const Exit& success, const Exit& failure) {
  switch (node.kind) {
  case Kind::Action: return action(node, success, failure);
  case Kind::Condition: return condition(node, success, failure);
  case Kind::Script:
  case Kind::AlwaysSuccess: return leave(success);
  case Kind::AlwaysFailure: return leave(failure);
  case Kind::Sleep: delay(node, "msec"); return leave(success);
  case Kind::Delay:
    delay(node, "delay_msec");
    return this->node(node.children.front(), success, failure);
  case Kind::Sequence: return inOrder(node, true, success, failure);
  case Kind::Fallback: return inOrder(node, false, success, failure);
  case Kind::SequenceWithMemory: return withMemory(node, success, failure);
  case Kind::IfThenElse: return ifThenElse(node, success, failure);
  case Kind::Inverter: return this->node(node.children.front(), failure, success);
  case Kind::ForceSuccess: return this->node(node.children.front(), success, success);
  case Kind::ForceFailure: return this->node(node.children.front(), failure, failure);
  case Kind::Repeat:
  case Kind::Retry:
  case Kind::KeepRunning: return loop(node, success, failure);
  case Kind::ParallelAll: return parallelAll(node, success, failure);
  case Kind::ReactiveSequence:
  case Kind::ReactiveFallback:
    if (!needsWatching(node, traits))
      return inOrder(node, node.kind == Kind::ReactiveSequence, success, failure);
    [[fallthrough]];
  case Kind::Parallel:
  case Kind::WhileDoElse:
  case Kind::Switch:
  case Kind::Timeout:
  case Kind::SubTree: {
    const auto skill = Composites(vocabulary).of(node);
    const auto at = statements.size();
    call(skill, traits.ends(node), success, failure);
    return commentAt(at, node);
  }
  }
}

void Body::condition(const Node& node, const Exit& success, const Exit& failure) {
  const auto at = statements.size();
  if (node.id == "ScriptCondition")
    vocabulary.approximate(node, "the script may have any result at any time");
  const auto ends = traits.ends(node);
  if (!ends.failure || !ends.success) return leave(ends.success ? success : failure);
  if (success == failure) return leave(success);
  const auto variable = vocabulary.condition(node);
  if (!failure.next())
    test(list(variable, "No"), failure);
  else
    test(list(variable, "Yes"), success);
  if (!failure.next()) leave(success);
  commentAt(at, node);
}

void Body::action(const Node& node, const Exit& success, const Exit& failure) {
  const auto at = statements.size();
  call(vocabulary.action(node), traits.ends(node), success, failure);
  commentAt(at, node);
}

void Body::call(const std::string& skill, Ends ends, const Exit& success, const Exit& failure) {
  statements.push_back(list(skill));
  if (!ends.success && !ends.failure) return;
  if (success == failure) return leave(success);
  if (!ends.failure) return leave(success);
  if (!ends.success) return leave(failure);
  if (failure.next()) return test(list("=", skill + ".status", "success"), success);
  test(list("/=", skill + ".status", "success"), failure);
  leave(success);
}

void Body::test(const Form& condition, const Exit& exit) {
  if (exit.next()) return;
  Form form = list("if", condition);
  append(form.parts, exit.jump);
  statements.push_back(std::move(form));
}

void Body::commentAt(std::size_t statement, const Node& node) {
  if (statement >= statements.size()) return;
  auto& comment = statements[statement].comment;
  comment = vocabulary.comment(node) + (comment.empty() ? "" : "\n") + comment;
}

void Body::inOrder(const Node& node, bool isSequence, const Exit& success, const Exit& failure) {
  const auto& early = isSequence ? failure : success;
  const auto end = early.next() ? vocabulary.names.take("done") : std::string();
  const auto exit = orTo(early, end);
  for (std::size_t i = 0; i + 1 < node.children.size(); ++i)
    this->node(node.children[i], isSequence ? Exit{} : exit, isSequence ? exit : Exit{});
  this->node(node.children.back(), success, failure);
  placeUsed(end);
}

void Body::withMemory(const Node& node, const Exit& success, const Exit& failure) {
  const auto last = static_cast<std::int64_t>(node.children.size()) - 1;
  const auto memory = vocabulary.counter(node, "_at", std::max<std::int64_t>(last, 1));
  const auto end = failure.next() ? vocabulary.names.take("done") : std::string();
  const auto exit = orTo(failure, end);
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    Body child(vocabulary);
    child.node(node.children[i], {}, exit);
    const auto following = i + 1 < node.children.size() ? i + 1 : 0;
    child.statements.push_back(list("set", list(memory, std::to_string(following))));
    Form step = list("if", list("=", memory, std::to_string(i)));
    append(step.parts, child.statements);
    statements.push_back(std::move(step));
  }
  leave(success);
  placeUsed(end);
}

void Body::delay(const Node& node, const char* port) {
  const auto seconds = secondsIn(node.port(port));
  Form wait = list("^", seconds.value_or("[0,...["));
  wait.comment = vocabulary.comment(node);
  if (!seconds && node.port(port).starts_with('{'))
    vocabulary.approximate(node, fmt::format("`{}` may be any time", port));
  else if (!seconds)
    vocabulary.fail(node, fmt::format("`{}` must be a number of milliseconds", port));
  statements.push_back(std::move(wait));
}

void Body::ifThenElse(const Node& node, const Exit& success, const Exit& failure) {
  const auto otherwise = vocabulary.names.take("otherwise");
  const bool meets = success.next() || failure.next();
  const auto end = meets ? vocabulary.names.take("done") : std::string();
  const auto yes = orTo(success, end);
  const auto no = orTo(failure, end);
  this->node(node.children[0], {}, to(otherwise));
  this->node(node.children[1], yes, no);
  place(otherwise);
  if (node.children.size() > 2)
    this->node(node.children[2], success, failure);
  else
    leave(failure);
  placeUsed(end);
}

void Body::placeUsed(const std::string& label) {
  if (label.empty()) return;
  const Form jump = list("goto", label);
  if (std::ranges::any_of(statements, [&](const Form& form) { return contains(form, jump); }))
    place(label);
}

} // namespace proskill::bridge::bt
