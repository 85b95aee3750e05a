#include "verify/checkpoint/parts.h"
#include "verify/graph/class_graph.h"
#include "verify/limits.h"

/// How the count of a class graph is saved and resumed.
namespace proskill::verify {

void ClassGraph::save() {
  checkpoint->save([this](CheckpointWriter& to) { write(to); });
}

/// Domains by their numbers; markings with their domains.
void ClassGraph::write(CheckpointWriter& to) const {
  to.number(result.transitions);
  to.number(domains.zones().size());
  for (ZoneId i = 0; i < domains.zones().size(); ++i)
    writeZone(to, domains.zones().dimension(i), domains.zones().matrix(i));
  to.number(markings.size());
  std::vector<Word> before(system.words);
  std::vector<Word> marking(system.words);
  for (std::uint32_t id = 0; id < markings.size() && !to.hasFailed(); ++id) {
    markings.read(id, marking.data());
    writeState(to, before.data(), marking.data(), system.words);
    std::swap(before, marking);
    writeClasses(to, id);
  }
  writeSteps(to, allWaiting());
  to.number(possibleSets.size());
  for (std::uint32_t i = 0; i < possibleSets.size(); ++i) writeSteps(to, possibleSets.at(i));
  to.number(domainKeys.size());
  for (auto key : domainKeys) to.number(key);
}

/// The domains of a marking, and which of them are expanded.
void ClassGraph::writeClasses(CheckpointWriter& to, std::uint32_t marking) const {
  const SetId all = classes.at(marking);
  const SetId done = expanded.at(marking);
  const auto write = [&](ZoneId domain) { to.number(domain); };
  to.number(sets.sizeOf(all));
  sets.eachIn(all, write);
  to.number(sets.sizeOf(done));
  if (done != all) sets.eachIn(done, write);
}

void ClassGraph::resume(CheckpointReader& from) {
  if (!from.flag()) from.fail();
  result.transitions = from.number();
  const auto zones = from.number();
  for (std::uint64_t i = 0; i < zones && !from.hasFailed(); ++i) {
    const auto zone = readZone(from, static_cast<std::uint32_t>(system.transitions.size() + 1));
    if (zone && domains.adopt(*zone) != i) from.fail();
    limits.check();
  }
  state.assign(system.words, 0);
  const auto count = from.numberBelow(kNone);
  for (std::uint64_t i = 0; i < count && readMarking(from); ++i) limits.check();
  std::vector<bool> waits(markings.size());
  for (auto id : readSteps(from, markings.size())) {
    if (waits[id] || expanded.at(id) == classes.at(id)) from.fail();
    waits[id] = true;
    waiting.push_back(id);
  }
  readDomains(from);
}

/// \return whether it is valid
bool ClassGraph::readMarking(CheckpointReader& from) {
  readState(from, state.data(), system.words);
  if (from.hasFailed() || !isState(system, state.data())) return from.fail(), false;
  enabling.compute(state.data(), enabled);
  const auto [id, isNew] = markings.add(state.data());
  if (!isNew) return from.fail(), false;
  describe(enabled);
  const SetId all = readClasses(from, from.numberBelow(kNone));
  const auto size = from.numberBelow(sets.sizeOf(all) + std::uint64_t{1});
  const SetId done = size == sets.sizeOf(all) ? all : readClasses(from, size);
  if (sets.unite(all, done) != all) from.fail();
  sets.eachIn(all, [&](ZoneId domain) {
    if (domains.zones().dimension(domain) != domains.dimensionOf(signatures.at(id))) from.fail();
  });
  classes.set(id, all);
  expanded.set(id, done);
  result.classes += sets.sizeOf(all);
  if (all != NumberSets::kEmpty) ++result.markings;
  return !from.hasFailed();
}

SetId ClassGraph::readClasses(CheckpointReader& from, std::uint64_t count) {
  SetId all = NumberSets::kEmpty;
  for (std::uint64_t i = 0; i < count && !from.hasFailed(); ++i)
    all = sets.unite(all, sets.single(from.indexBelow(domains.zones().size())));
  if (sets.sizeOf(all) != count) from.fail();
  return all;
}

void ClassGraph::readDomains(CheckpointReader& from) {
  const auto sets = from.number();
  for (std::uint64_t i = 0; i < sets && !from.hasFailed(); ++i)
    if (!possibleSets.add(readSteps(from, kNone)).isNew) from.fail();
  const auto keys = from.number();
  for (std::uint64_t i = 0; i < keys && !from.hasFailed(); ++i)
    if (addDomain(from.number()) != i) from.fail();
}

} // namespace proskill::verify
