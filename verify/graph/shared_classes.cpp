#include "verify/checkpoint/parts.h"
#include "verify/graph/class_graph.h"
#include "verify/limits.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <tuple>

/// How several ranks count the classes of one graph.
namespace proskill::verify {

/// Sends the classes that follow the pending ones in the marking of another rank.
void ClassGraph::send(const MarkingStep& step) {
  const std::uint32_t after = expanders[0]->translate(step.signature, domains);
  const auto image = images.of(pending, {signature, step.transition, after});
  if (image.fired == 0) return;
  result.transitions += image.fired;
  const auto marking =
      std::span(ready.expanded[ready.entered].words).subspan(step.words, system.words);
  const unsigned owner = ownerOf(*ranks, marking);
  auto& last = lastSent[owner];
  if (exchange->isNew(owner)) std::ranges::fill(last, 0);
  exchange->add(owner, [&](CheckpointWriter& record) {
    writeState(record, last.data(), marking.data(), system.words);
    last.assign(marking.begin(), marking.end());
    record.number(sets.sizeOf(image.domains));
    sets.eachIn(image.domains, [&](ZoneId domain) {
      writeZone(record, domains.zones().dimension(domain), domains.zones().matrix(domain));
    });
  });
}

/// A rank that has met a limit still empties its mailbox, so that the others can finish the round.
void ClassGraph::receive(CheckpointReader& records) {
  if (result.stopped.empty()) result.stopped = limits.met(progress());
  if (!result.stopped.empty()) return;
  std::ranges::fill(state, 0);
  while (records.flag()) receiveRecord(records);
}

void ClassGraph::receiveRecord(CheckpointReader& records) {
  readState(records, state.data(), system.words);
  const auto [id, isNew] = markings.add(state.data());
  if (isNew) {
    enabling.compute(state.data(), enabled);
    describe(enabled);
  }
  SetId reached = NumberSets::kEmpty;
  for (auto left = records.number(); left > 0; --left) {
    const auto domain =
        readZone(records, static_cast<std::uint32_t>(system.transitions.size() + 1));
    assert(domain);
    reached = sets.unite(reached, sets.single(domains.adopt(*domain)));
  }
  enter(id, reached);
}

/// Whether a rank has something to expand, and all are able to.
bool ClassGraph::isRoundLeft() {
  exchange->finishRound();
  std::array<std::uint64_t, 2> numbers{waiting.size(),
                                       result.stopped.empty() && failure.message.empty() ? 0U : 1U};
  ranks->sum(numbers);
  return numbers[0] != 0 && numbers[1] == 0;
}

/// What ended the count on one rank has ended it on all.
void ClassGraph::shareEnd() {
  result.stopped = firstOf(ranks->gather(result.stopped));
  const auto origins = ranks->gather(std::to_string(failure.origin));
  const auto messages = ranks->gather(failure.message);
  const auto first = std::ranges::find_if(messages, [](const auto& it) { return !it.empty(); });
  if (first == messages.end()) return;
  failure = {*first, static_cast<fiacre::OriginId>(
                         std::stoul(origins[static_cast<std::size_t>(first - messages.begin())]))};
}

/// Replaces the counts of this rank by those of all.
void ClassGraph::addUp() {
  DistinctCount distinct(*ranks);
  result.domains = domainsOfAll(distinct);
  std::array<std::uint64_t, 6> numbers{result.classes,
                                       result.markings,
                                       result.transitions,
                                       result.bytes,
                                       exchange->sent().messages + distinct.sent().messages,
                                       exchange->sent().bytes + distinct.sent().bytes};
  ranks->sum(numbers);
  result.ranks = ranks->count();
  std::tie(result.classes, result.markings, result.transitions, result.bytes, result.messages,
           result.sentBytes) = std::tuple_cat(numbers);
}

/// Ranks number domains and sets of transitions as they find them, so these are compared as such.
std::uint64_t ClassGraph::domainsOfAll(DistinctCount& distinct) const {
  for (const auto key : domainKeys) {
    const std::string item = bytesOf([&](CheckpointWriter& to) {
      writeSteps(to, possibleSets.at(static_cast<std::uint32_t>(key >> 32)));
      const auto domain = static_cast<ZoneId>(key);
      writeZone(to, domains.zones().dimension(domain), domains.zones().matrix(domain));
    });
    distinct.add(item);
  }
  return distinct.total();
}

} // namespace proskill::verify
