#include "verify/guide/frontier.h"

namespace proskill::verify {

void Frontier::add(const Word* state, TransitionId lastStep) {
  const Node node = added++;
  if (walks) walks->add(node);
  if (!distance) return;
  const Estimate estimate{distance->from(state), node};
  isTaken.push_back(false);
  all.push(estimate);
  if (lastStep != kNone && usefulSteps.contains(lastStep)) useful.push(estimate);
}

Frontier::Node Frontier::take() {
  const Node inOrder = taken++;
  if (walks) return walks->take();
  if (!distance) return inOrder;
  isTurnOfUseful = !isTurnOfUseful;
  if (isTurnOfUseful)
    if (const auto node = takeFrom(useful)) return *node;
  return takeFrom(all).value();
}

std::optional<Frontier::Node> Frontier::takeFrom(Queue& queue) {
  while (!queue.empty()) {
    const Node node = queue.top().second;
    queue.pop();
    if (isTaken[node]) continue;
    isTaken[node] = true;
    return node;
  }
  return std::nullopt;
}

void Frontier::expand(const Word* state) {
  if (distance) usefulSteps = distance->usefulSteps(state);
}

} // namespace proskill::verify
