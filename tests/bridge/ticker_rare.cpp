#include "bridge/bt/tree/traits.h"
#include "tests/bridge/ticking.h"

#include <algorithm>
#include <array>

namespace proskill::test {

int& Ticker::entryOf(std::size_t n) {
  const auto code = scriptOf(*nodes[n].node);
  return state[nodes.size() + entries.at(code.substr(0, code.find(' ')))].at;
}

Status Ticker::script(std::size_t n) {
  const auto code = scriptOf(*nodes[n].node);
  if (code.starts_with('@')) entryOf(n) = code.back() - '0';
  return Status::Success;
}

Status Ticker::scriptCondition(std::size_t n) {
  const auto code = scriptOf(*nodes[n].node);
  const bool holds =
      code.starts_with('@') ? entryOf(n) == code.back() - '0' : choices.below(2) == 0;
  return holds ? Status::Success : Status::Failure;
}

Status Ticker::persistent(std::size_t n) {
  const auto result = inOrder(n, Status::Success, true);
  return result == Status::Skipped ? Status::Success : result;
}

Status Ticker::nonblocking(std::size_t n) {
  bool all = true;
  for (const auto child : nodes[n].children) {
    const auto result = tick(child);
    if (result == Status::Failure) return result;
    all = all && result == Status::Success;
  }
  return all ? Status::Success : Status::Running;
}

Status Ticker::pauseResume(std::size_t n) {
  static constexpr std::array<std::size_t, 4> kChild{0, 2, 1, 3};
  const auto& kids = nodes[n].children;
  auto& phase = state[n].at;
  if (phase != 2 && choices.below(2) == 1) switchTo(n, 1);
  if (phase == 2 && choices.below(2) == 1) switchTo(n, 3);
  const auto child = kChild.at(static_cast<std::size_t>(phase));
  const auto result = child < kids.size() ? tick(kids[child]) : Status::Skipped;
  if (result == Status::Failure || (result == Status::Running && child < kids.size()))
    return result;
  if (phase == 0) return Status::Success;
  if (phase % 2 == 1) phase = (phase + 1) % 4;
  return Status::Running;
}

void Ticker::switchTo(std::size_t n, int phase) {
  for (const auto child : nodes[n].children) halt(child);
  state[n].at = phase;
}

Status Ticker::own(std::size_t n) {
  for (const auto child : nodes[n].children) {
    const auto choice = choices.below(3);
    if (choice == 1) tick(child);
    if (choice == 2) halt(child);
  }
  return std::array{Status::Running, Status::Success, Status::Failure}.at(choices.below(3));
}

Status Ticker::runOnce(std::size_t n) {
  const bool skips = nodes[n].node->port("then_skip", "true") == "true";
  if (state[n].at > 0 && skips) return Status::Skipped;
  if (state[n].at > 0) return state[n].at == 1 ? Status::Success : Status::Failure;
  const auto result = tick(nodes[n].children[0]);
  if (result == Status::Success) state[n].at = 1;
  if (result == Status::Failure) state[n].at = 2;
  return result;
}

Status Ticker::precondition(std::size_t n) {
  const auto& node = *nodes[n].node;
  if (state[n].at == 0 && choices.below(2) == 1) {
    const auto otherwise =
        node.id == "SkipUnlessUpdated" ? "SKIPPED" : node.port("else", "FAILURE");
    return otherwise == "RUNNING" ? Status::Running : named(otherwise);
  }
  state[n].at = 1;
  return tick(nodes[n].children[0]);
}

Status Ticker::named(const std::string& status) {
  if (status == "SUCCESS") return Status::Success;
  return status == "FAILURE" ? Status::Failure : Status::Skipped;
}

Status Ticker::queue(std::size_t n) {
  const auto child = nodes[n].children[0];
  const auto elements = nodes[n].node->port("queue");
  const bool known = elements.front() >= '0' && elements.front() <= '9';
  const auto count = static_cast<int>(std::ranges::count(elements, ';')) + 1;
  if (!state[child].running) {
    const bool isEmpty = known ? state[n].at == count : choices.below(2) == 1;
    if (isEmpty) return named(nodes[n].node->port("if_empty", "SUCCESS"));
    if (known) ++state[n].at;
  }
  return tick(child) == Status::Failure ? Status::Failure : Status::Running;
}

Status Ticker::tryCatch(std::size_t n) {
  const auto& kids = nodes[n].children;
  while (state[n].done == 0 && state[n].at + 1 < static_cast<int>(kids.size())) {
    const auto result = tick(kids[static_cast<std::size_t>(state[n].at)]);
    if (result == Status::Running) return result;
    if (result == Status::Failure) state[n].done = 1;
    if (result == Status::Skipped) ++state[n].good;
    ++state[n].at;
  }
  const bool allSkipped = state[n].good + 1 == kids.size();
  if (state[n].done == 0) return allSkipped ? Status::Skipped : Status::Success;
  return tick(kids.back()) == Status::Running ? Status::Running : Status::Failure;
}

Status Ticker::rounds(std::size_t n, Status again, const char* port) {
  const auto child = nodes[n].children[0];
  const int limit = std::stoi(nodes[n].node->port(port));
  for (;;) {
    const bool wasRunning = state[child].running;
    const auto result = tick(child);
    if (result != again) return result;
    if (limit != -1 && ++state[n].at >= limit) return again;
    if (!wasRunning) return Status::Running; // it asks for another tick at once
  }
}

Status Ticker::timeout(std::size_t n) {
  const auto child = nodes[n].children[0];
  if (lasts(child) && choices.below(2) == 1) return Status::Failure;
  return tick(child);
}

Status Ticker::recovery(std::size_t n) {
  const auto& kids = nodes[n].children;
  const int retries = std::stoi(nodes[n].node->port("number_of_retries", "1"));
  for (;;) {
    const int count = state[n].at / 2;
    const bool recovers = state[n].at % 2 == 1;
    const auto result = tick(kids[recovers ? 1 : 0]);
    if (result == Status::Running) return result;
    if (!recovers && (result == Status::Success || count >= retries)) return result;
    if (recovers && result == Status::Failure) return result;
    ++state[n].at;
  }
}

Status Ticker::roundRobin(std::size_t n) {
  const auto& kids = nodes[n].children;
  const auto count = static_cast<int>(kids.size());
  while (static_cast<int>(state[n].done) < count) {
    const auto result = tick(kids[static_cast<std::size_t>(state[n].at)]);
    if (result != Status::Failure) return result;
    state[n].at = (state[n].at + 1) % count;
    ++state[n].done;
  }
  return Status::Failure;
}

Status Ticker::pipeline(std::size_t n) {
  const auto& kids = nodes[n].children;
  for (std::size_t i = 0; i < kids.size(); ++i) {
    const auto result = tick(kids[i]);
    if (result == Status::Failure) return result;
    if (result == Status::Success || static_cast<int>(i) < state[n].at) continue;
    state[n].at = static_cast<int>(i);
    return result;
  }
  return Status::Success;
}

bool Ticker::lasts(std::size_t n) const {
  const auto& node = *nodes[n].node;
  const bool endless = node.kind == Kind::KeepRunning || bridge::bt::roundsOf(node) == -1;
  if (node.kind == Kind::Action || endless) return state[n].running;
  return std::ranges::any_of(nodes[n].children, [&](auto child) { return lasts(child); });
}

} // namespace proskill::test
