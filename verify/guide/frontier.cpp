#include "verify/guide/frontier.h"

namespace proskill::verify {

void Frontier::add(const Word* state, TransitionId lastStep, std::span<const TransitionId> steps) {
  const Node node = added++;
  if (walks) walks->add(node);
  if (!distance && !novelty) return;
  isTaken.push_back(false);
  if (plan)
    addByPlan(state, steps, node);
  else if (distance)
    addByDistance(state, lastStep, node);
  else
    newest.push({novelty->seePair(state), 0, {0, node}});
}

void Frontier::addByPlan(const Word* state, std::span<const TransitionId> steps, Node node) {
  const auto left = plan->add(steps);
  furthest.push({left, novelty->seeValue(state, left), {UINT32_MAX - node, node}});
  newest.push({novelty->seePair(state), left, {node, node}});
}

Frontier::Node Frontier::takeByPlan() {
  const auto node = (turns++ % 8 < 7 ? takeFrom(furthest) : takeFrom(newest)).value();
  plan->expand(node);
  return node;
}

void Frontier::addByDistance(const Word* state, TransitionId lastStep, Node node) {
  const auto [length, left] = distance->from(state);
  all.push({length, node});
  if (lastStep != kNone && usefulSteps.contains(lastStep)) useful.push({length, node});
  if (novelty) newest.push({novelty->seeValue(state, left), left, {length, node}});
}

Frontier::Node Frontier::take() {
  const Node inOrder = taken++;
  if (walks) return walks->take();
  if (plan) return takeByPlan();
  if (distance) return takeByDistance();
  return novelty ? takeFrom(newest).value() : inOrder;
}

Frontier::Node Frontier::takeByDistance() {
  const std::uint32_t turn = turns++ % (novelty ? 3 : 2);
  std::optional<Node> node;
  if (turn == 0) node = takeFrom(useful);
  if (turn == 2) node = takeFrom(newest);
  return node ? *node : takeFrom(all).value();
}

template <class Rank> std::optional<Frontier::Node> Frontier::takeFrom(Queue<Rank>& queue) {
  while (!queue.empty()) {
    const Node node = nodeOf(queue.top());
    queue.pop();
    if (isTaken[node]) continue;
    isTaken[node] = true;
    return node;
  }
  return std::nullopt;
}

void Frontier::expand(const Word* state) {
  if (distance) usefulSteps = distance->usefulSteps(state);
  if (novelty) novelty->expand(state);
}

} // namespace proskill::verify
