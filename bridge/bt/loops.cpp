#include "bridge/bt/body.h"

#include <fmt/format.h>

#include <utility>

namespace proskill::bridge::bt {

Form Body::nextTick(bool atOnce) const {
  const auto& tick = vocabulary.leaves.tick;
  return list("^", (atOnce ? "[0," : "]0,") + (tick.empty() ? "...[" : tick + "]"));
}

bool repeatsChildren(const Node& node) {
  switch (node.kind) {
  case Kind::Action:
  case Kind::Condition:
  case Kind::Script:
  case Kind::Sleep:
  case Kind::AlwaysSuccess:
  case Kind::AlwaysFailure:
  case Kind::Sequence:
  case Kind::SequenceWithMemory:
  case Kind::Fallback:
  case Kind::Parallel:
  case Kind::ParallelAll:
  case Kind::IfThenElse:
  case Kind::Inverter:
  case Kind::ForceSuccess:
  case Kind::ForceFailure:
  case Kind::Timeout:
  case Kind::Delay:
  case Kind::RunOnce:
  case Kind::Precondition:
  case Kind::TryCatch:
  case Kind::SubTree: return false;
  case Kind::ReactiveSequence:
  case Kind::ReactiveFallback:
  case Kind::WhileDoElse:
  case Kind::Switch:
  case Kind::KeepRunning:
  case Kind::Recovery:
  case Kind::RoundRobin:
  case Kind::Persistent:
  case Kind::Pipeline:
  case Kind::Nonblocking:
  case Kind::PauseResume:
  case Kind::Rate:
  case Kind::Own: return true;
  case Kind::Repeat:
  case Kind::Retry: return roundsOf(node) != 1;
  case Kind::Queue: return elementsIn(node) != 1;
  }
  std::unreachable();
}

void Body::loop(const Node& node, const Exit& success, const Exit& failure) {
  const auto at = statements.size();
  const auto rounds = roundsOf(node);
  const auto& port = node.port(node.kind == Kind::Repeat ? "num_cycles" : "num_attempts");
  const bool isEndless = node.kind == Kind::KeepRunning || rounds == -1;
  const bool isCounted = !isEndless && rounds && *rounds > 0 && *rounds <= 1'000'000;
  if (!isEndless && !isCounted && !port.starts_with('{'))
    return vocabulary.fail(
        node, fmt::format("`{}` needs a number of rounds from 1 to 1,000,000, or -1", node.id));
  const auto ends = traits.ends(node.children.front());
  const bool repeats = node.kind == Kind::Retry ? ends.failure : ends.success;
  if (repeats && vocabulary.turn && node.kind != Kind::KeepRunning && rounds != 1)
    vocabulary.approximate(node, "a tick may begin several rounds");
  if (!repeats)
    this->node(node.children.front(), success, failure); // whose only result ends the loop
  else if (isEndless)
    endlessLoop(node, node.kind == Kind::Retry ? success : failure);
  else if (isCounted)
    countedLoop(node, *rounds, success, failure);
  else
    anyLoop(node, success, failure);
  commentAt(at, node);
}

void Body::endlessLoop(const Node& node, const Exit& exit) {
  const auto& child = node.children.front();
  const auto label = vocabulary.names.take("again");
  Exit again = to(label);
  const bool keeps = node.kind == Kind::KeepRunning;
  if (keeps || traits.mayEndAtOnce(child)) again = to(waitBefore(label, nextTick(!keeps)));
  place(label);
  // KeepRunningUntilFailure ends with a failure, as Repeat does.
  if (node.kind == Kind::Retry)
    this->node(child, exit, again);
  else
    this->node(child, again, exit);
}

/// A wait that leads to a label that is placed next. \return the label of the wait
std::string Body::waitBefore(const std::string& label, Form wait) {
  const auto waits = vocabulary.names.take("next");
  leave(to(label));
  place(waits);
  append(statements, lasting(std::move(wait)));
  return waits;
}

void Body::countedLoop(const Node& node, std::int64_t rounds, const Exit& success,
                       const Exit& failure) {
  const auto& child = node.children.front();
  if (rounds == 1) return this->node(child, success, failure);
  const bool repeats = node.kind == Kind::Repeat;
  const auto& early = repeats ? failure : success;
  const auto label = vocabulary.names.take("again");
  const auto end = early.next() ? vocabulary.names.take("done") : std::string();
  const auto exit = orTo(early, end);
  const auto count = vocabulary.counter(node, "_count", rounds);
  statements.push_back(list("set", list(count, "0")));
  place(label);
  this->node(child, repeats ? Exit{} : exit, repeats ? exit : Exit{});
  statements.push_back(list("set", list(count, list("+", count, "1"))));
  test(list("<", count, std::to_string(rounds)), to(label));
  leave(repeats ? success : failure);
  placeUsed(end);
}

/// The blackboard says how many rounds: any number.
void Body::anyLoop(const Node& node, const Exit& success, const Exit& failure) {
  const bool repeats = node.kind == Kind::Repeat;
  const auto& early = repeats ? failure : success;
  const auto label = vocabulary.names.take("again");
  const auto end = early.next() ? vocabulary.names.take("done") : std::string();
  const auto exit = orTo(early, end);
  const auto more = vocabulary.anyOf((node.name.empty() ? node.id : node.name) + "_continues",
                                     {"Yes", "No"}, vocabulary.comment(node));
  vocabulary.approximate(node, "the number of rounds may be any");
  place(label);
  this->node(node.children.front(), repeats ? Exit{} : exit, repeats ? exit : Exit{});
  Exit again{lasting(nextTick(true))};
  append(again.jump, to(label).jump);
  test(list(more, "Yes"), again);
  leave(repeats ? success : failure);
  placeUsed(end);
}

} // namespace proskill::bridge::bt
