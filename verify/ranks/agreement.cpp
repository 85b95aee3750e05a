#include "verify/checkpoint/parts.h"
#include "verify/explore/conclude.h"
#include "verify/ranks/distinct_count.h"
#include "verify/ranks/rank_explorer.h"

#include <algorithm>
#include <array>

/// What the ranks agree on after each level, and at the end.
namespace proskill::verify {

namespace {

constexpr std::size_t kLongestText = std::size_t{1} << 16; // bytes

} // namespace

Progress RankExplorer::progress() const {
  return {all.classes,
          all.markings,
          all.nodes,
          graph.bytes() + candidates.bytes() + recentlySent.bytes() + exchange.bytes(),
          limits.seconds(),
          goals.goals.size() - open,
          goals.goals.size()};
}

/// Adds up what all ranks have found so far.
void RankExplorer::addUp() {
  std::array<std::uint64_t, 8> numbers{graph.size() - first,
                                       result.statistics.stopped.empty() ? 0U : 1U,
                                       result.failure.empty() ? 0U : 1U,
                                       finds.size(),
                                       graph.size(),
                                       graph.states.size(),
                                       result.statistics.transitions,
                                       progress().bytes};
  ranks.sum(numbers);
  const auto& [nodes, limited, failed, found, classes, markings, transitions, bytes] = numbers;
  all = {nodes, limited, failed, found, classes, markings, transitions, bytes};
}

bool RankExplorer::isOver() {
  addUp();
  if (all.found != 0) shareFinds();
  if (open == 0 && !goals.goals.empty()) return true;
  if (all.failed != 0) shareFailure();
  if (all.limited != 0)
    result.statistics.stopped = firstOf(ranks.gather(result.statistics.stopped));
  return all.failed != 0 || all.limited != 0 || all.nodes == 0;
}

void RankExplorer::shareFailure() {
  const auto texts = ranks.gather(bytesOf([this](CheckpointWriter& to) {
    to.text(result.failure);
    to.number(result.failureOrigin);
  }));
  for (const auto& text : texts) {
    auto from = readerOf(text);
    result.failure = from.text(kLongestText);
    result.failureOrigin = static_cast<fiacre::OriginId>(from.number());
    if (!result.failure.empty()) return;
  }
}

/// Each goal is shown by the first rank that has reached it in this level.
void RankExplorer::shareFinds() {
  const auto texts = ranks.gather(bytesOf([this](CheckpointWriter& to) {
    for (const auto& find : finds) {
      to.number(find.goal + 1);
      to.number(find.from.rank + 1U);
      to.number(find.from.node);
      writeSteps(to, find.steps);
    }
    to.number(0);
  }));
  std::vector<bool> shown(goals.goals.size());
  finds.clear();
  for (const auto& text : texts) {
    auto from = readerOf(text);
    while (const auto goal = from.number()) {
      const auto rank = static_cast<std::uint32_t>(from.number() - 1);
      const auto node = static_cast<NodeIndex>(from.number());
      Find find{goal - 1, {rank, node}, readSteps(from, system.transitions.size())};
      if (!shown[find.goal]) note(find);
      shown[find.goal] = true;
    }
  }
}

void RankExplorer::note(const Find& find) {
  goals.found[find.goal] = true;
  ++goals.closed;
  --open;
  exploreWithinLimits(result.statistics, [&] { show(find); });
}

/// \throw LimitMet
void RankExplorer::show(const Find& find) {
  Steps steps;
  if (find.from.rank != kNone) steps = pathTo(find.from).steps;
  append(steps, find.steps);
  result.goals[find.goal] = std::move(steps);
  if (onFound) onFound(find.goal, *result.goals[find.goal]);
}

void RankExplorer::conclude() {
  auto& statistics = result.statistics;
  verify::conclude(statistics, all.nodes == 0, result.failure, "all questions decided");
  statistics.classes = all.classes;
  statistics.markings = all.markings;
  statistics.transitions = all.transitions;
  statistics.bytes = all.bytes;
  statistics.seconds = limits.seconds();
  DistinctCount domains(ranks);
  statistics.domains = count(domains);
  statistics.ranks = ranks.count();
  std::array<std::uint64_t, 2> sent{exchange.sent().messages + domains.sent().messages,
                                    exchange.sent().bytes + domains.sent().bytes};
  ranks.sum(sent);
  statistics.messages = sent[0];
  statistics.sentBytes = sent[1];
}

/// The number of distinct zones of the nodes.
std::uint64_t RankExplorer::count(DistinctCount& distinct) {
  Bits zones;
  for (NodeIndex i = 0; i < graph.size(); ++i) zones.insert(graph.zoneOf(i));
  zones.each([&](ZoneId zone) {
    const auto matrix = graph.timing.zones().matrix(zone);
    distinct.add({reinterpret_cast<const char*>(matrix.data()), matrix.size_bytes()});
  });
  return distinct.total();
}

} // namespace proskill::verify
