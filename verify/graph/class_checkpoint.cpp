#include "verify/checkpoint/parts.h"
#include "verify/graph/class_graph.h"
#include "verify/limits.h"

/// How the count of a class graph is saved and resumed.
namespace proskill::verify {

void ClassGraph::save() {
  checkpoint->save([this](CheckpointWriter& to) { write(to); });
}

/// Domains by their numbers; markings with their domains, in the order in which these were found.
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
    to.number(classes.at(id).size());
    to.number(classes.at(id).size() - info[id].done);
    for (auto domain : classes.at(id)) to.number(domain);
  }
  writeSteps(to, {waiting.begin(), waiting.end()});
  to.number(possibleSets.size());
  for (const auto& set : possibleSets) writeSteps(to, set);
  to.number(domainKeys.size());
  for (auto key : domainKeys) to.number(key);
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
  for (auto id : readSteps(from, info.size())) {
    if (info[id].waits || info[id].done == classes.at(id).size()) from.fail();
    info[id].waits = true;
    waiting.push_back(id);
  }
  readDomains(from);
}

/// \return whether it is valid
bool ClassGraph::readMarking(CheckpointReader& from) {
  readState(from, state.data(), system.words);
  if (from.hasFailed() || !isState(system, state.data())) return from.fail(), false;
  enabling.compute(state.data(), enabled);
  const std::uint32_t id = add(state, enabled);
  if (id + 1 != info.size()) return from.fail(), false;
  const auto size = from.numberBelow(kNone);
  const auto open = from.numberBelow(size + 1);
  for (std::uint64_t i = 0; i < size && !from.hasFailed(); ++i) {
    const ZoneId domain = from.indexBelow(domains.zones().size());
    if (from.hasFailed() || !classes.insert(id, domain) ||
        domains.zones().dimension(domain) != domains.dimensionOf(info[id].signature))
      return from.fail(), false;
  }
  info[id].done = static_cast<std::uint32_t>(size - open);
  result.classes += size;
  if (size > 0) ++result.markings;
  return !from.hasFailed();
}

void ClassGraph::readDomains(CheckpointReader& from) {
  const auto sets = from.number();
  for (std::uint64_t i = 0; i < sets && !from.hasFailed(); ++i) {
    possible = readSteps(from, kNone);
    if (numberOfPossible() != i) from.fail();
  }
  const auto keys = from.number();
  for (std::uint64_t i = 0; i < keys && !from.hasFailed(); ++i)
    if (addDomain(from.number()) != i) from.fail();
}

} // namespace proskill::verify
