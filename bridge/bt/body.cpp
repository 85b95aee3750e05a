#include "bridge/bt/body.h"

#include "bridge/bt/composites.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::bridge::bt {

Exit succeed() { return {{list("success", "done")}}; }
Exit fail() { return {{list("failure", "failed")}}; }
Exit skipped() { return {{list("failure", "skipped")}}; }
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

void Body::node(const Node& node, const Exit& success, const Exit& failure, const Skip& skip) {
  if (maySkip(node) && !skip)
    return vocabulary.fail(node, "a node that may be skipped is only supported below a sequence, a "
                                 "fallback, a `TryCatch` or a loop over a queue");
  if (!hasPrecondition(node)) return plain(node, success, failure, skip);
  const auto done = vocabulary.names.take("done");
  const auto yes = orTo(success, done);
  const auto no = orTo(failure, done);
  preconditions(node, yes, no, skip);
  if (node.ports.contains("_while"))
    whileTrue(node, success, failure, *skip);
  else
    plain(node, success, failure, skip);
  placeUsed(done);
}

void Body::preconditions(const Node& node, const Exit& success, const Exit& failure,
                         const Skip& skip) {
  scripted(node, "_failureIf", failure);
  scripted(node, "_successIf", success);
  if (skip) scripted(node, "_skipIf", *skip);
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

void Body::plain(const Node& node, const Exit& success, const Exit& failure, const Skip& given) {
  const bool outer = vocabulary.isRepeated;
  vocabulary.isRepeated = outer || repeatsChildren(node);
  started(node, success, failure, given);
  vocabulary.isRepeated = outer;
}

void Body::started(const Node& node, const Exit& success, const Exit& failure, const Skip& given) {
  const auto skip = maySkipInside(node) ? given : Skip();
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
  case Kind::Sequence: return inOrder(node, true, success, failure, skip);
  case Kind::Fallback: return inOrder(node, false, success, failure, skip);
  case Kind::SequenceWithMemory: return withMemory(node, success, failure);
  case Kind::IfThenElse: return ifThenElse(node, success, failure, skip);
  case Kind::Inverter: return this->node(node.children.front(), failure, success, skip);
  case Kind::ForceSuccess: return this->node(node.children.front(), success, success, skip);
  case Kind::ForceFailure: return this->node(node.children.front(), failure, failure, skip);
  case Kind::RunOnce: return runOnce(node, success, failure, skip);
  case Kind::Precondition: return precondition(node, success, failure, skip);
  case Kind::Queue: return queue(node, success, failure, skip);
  case Kind::TryCatch: return tryCatch(node, success, failure, skip);
  case Kind::Repeat:
  case Kind::Retry:
  case Kind::KeepRunning: return loop(node, success, failure);
  case Kind::ParallelAll: return parallelAll(node, success, failure);
  case Kind::Recovery: return recovery(node, success, failure);
  case Kind::RoundRobin: return anyOrder(node, false, success, failure);
  case Kind::Persistent: return anyOrder(node, true, success, failure);
  case Kind::Rate: return rate(node, success, failure, skip);
  case Kind::ReactiveSequence:
  case Kind::ReactiveFallback:
    if (!needsWatching(node, traits))
      return inOrder(node, node.kind == Kind::ReactiveSequence, success, failure, skip);
    [[fallthrough]];
  case Kind::Parallel:
  case Kind::Pipeline:
  case Kind::Nonblocking:
  case Kind::PauseResume:
  case Kind::Own:
  case Kind::WhileDoElse:
  case Kind::Switch:
  case Kind::Timeout:
  case Kind::SubTree: return composite(node, success, failure, skip);
  }
}

void Body::composite(const Node& node, const Exit& success, const Exit& failure, const Skip& skip) {
  const bool passes = passesTurn(node.kind);
  if (!passes && vocabulary.turn && vocabulary.turn->child > 1)
    vocabulary.approximate(node, "it may go on between two ticks");
  const auto skill = Composites(vocabulary).of(node);
  const auto at = statements.size();
  statements.push_back(list(skill));
  if (!passes) append(statements, nextTurn());
  called(skill, traits.endsInside(node), success, failure, skip,
         node.kind == Kind::ReactiveFallback);
  commentAt(at, node);
}

void Body::condition(const Node& node, const Exit& success, const Exit& failure) {
  const auto at = statements.size();
  if (node.id == "ScriptCondition")
    vocabulary.approximate(node, "the script may have any result at any time");
  const auto ends = traits.endsInside(node);
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
  const auto skill = vocabulary.action(node);
  append(statements, lastingAction(node, skill));
  called(skill, traits.endsInside(node), success, failure, {});
  commentAt(at, node);
}

void Body::called(const std::string& skill, Ends ends, const Exit& success, const Exit& failure,
                  const Skip& skip, bool byGuard) {
  if (skip) test(list("=", skill + ".res", "skipped"), *skip);
  if (!ends.success && !ends.failure) return;
  if (success == failure) return leave(success);
  if (!ends.failure) return leave(success);
  if (!ends.success) return leave(failure);
  const auto status = [&](bool succeeds) {
    return list(succeeds == byGuard ? "/=" : "=", skill + ".status",
                byGuard ? "failure" : "success");
  };
  if (failure.next()) return test(status(true), success);
  test(status(false), failure);
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

void Body::inOrder(const Node& node, bool isSequence, const Exit& success, const Exit& failure,
                   const Skip& skip) {
  if (std::ranges::all_of(node.children, maySkip))
    return inOrderOrSkipped(node, isSequence, success, failure, *skip);
  const auto& early = isSequence ? failure : success;
  const auto end = early.next() ? vocabulary.names.take("done") : std::string();
  const auto exit = orTo(early, end);
  for (std::size_t i = 0; i + 1 < node.children.size(); ++i)
    child(node.children[i], isSequence, {}, exit);
  child(node.children.back(), isSequence, isSequence ? success : failure, early);
  placeUsed(end);
}

void Body::inOrderOrSkipped(const Node& node, bool isSequence, const Exit& success,
                            const Exit& failure, const Exit& skip) {
  const auto ran = vocabulary.counter(node, "_ran", 1);
  const auto end = vocabulary.names.take("done");
  const auto early = orTo(isSequence ? failure : success, end);
  statements.push_back(list("set", list(ran, "0")));
  for (const auto& child : node.children) {
    const auto next = vocabulary.names.take("skipped");
    this->node(child, isSequence ? Exit{} : early, isSequence ? early : Exit{}, to(next));
    statements.push_back(list("set", list(ran, "1")));
    placeUsed(next);
  }
  test(list("=", ran, "0"), skip);
  leave(isSequence ? success : failure);
  placeUsed(end);
}

void Body::child(const Node& child, bool isSequence, const Exit& goOn, const Exit& early) {
  const auto skipped = maySkip(child) ? vocabulary.names.take("skipped") : std::string();
  this->node(child, isSequence ? goOn : early, isSequence ? early : goOn, orTo(goOn, skipped));
  placeUsed(skipped);
}

void Body::withMemory(const Node& node, const Exit& success, const Exit& failure) {
  if (!vocabulary.isRepeated && !std::ranges::all_of(node.children, maySkip))
    return inOrder(node, true, success, failure, {}); // it never remembers anything
  const auto last = static_cast<std::int64_t>(node.children.size()) - 1;
  const auto memory = vocabulary.counter(node, "_at", std::max<std::int64_t>(last, 1));
  const auto end = failure.next() ? vocabulary.names.take("done") : std::string();
  const auto exit = orTo(failure, end);
  if (std::ranges::all_of(node.children, maySkip))
    vocabulary.fail(node, "a `SequenceWithMemory` whose children may all be skipped is not "
                          "supported");
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    Body child(vocabulary);
    child.child(node.children[i], true, {}, exit);
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
  append(statements, lasting(std::move(wait)));
}

void Body::ifThenElse(const Node& node, const Exit& success, const Exit& failure,
                      const Skip& skip) {
  const auto otherwise = vocabulary.names.take("otherwise");
  const bool meets = success.next() || failure.next();
  const auto end = meets ? vocabulary.names.take("done") : std::string();
  const auto yes = orTo(success, end);
  const auto no = orTo(failure, end);
  this->node(node.children[0], {}, to(otherwise));
  this->node(node.children[1], yes, no, skip);
  place(otherwise);
  if (node.children.size() > 2)
    this->node(node.children[2], success, failure, skip);
  else
    leave(failure);
  placeUsed(end);
}

bool Body::jumpsTo(const std::string& label) const {
  const Form jump = list("goto", label);
  return std::ranges::any_of(statements, [&](const Form& form) { return contains(form, jump); });
}

void Body::placeUsed(const std::string& label) {
  if (!label.empty() && jumpsTo(label)) place(label);
}

} // namespace proskill::bridge::bt
