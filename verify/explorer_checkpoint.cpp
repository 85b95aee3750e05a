#include "verify/explore/explorer.h"

/// A saved search is the list of its nodes in the order in which they were found, each with the
/// node before it, so that the graph is built again just as the search had built it. Zones and
/// signatures are stored once; a new state is stored as its difference from that of the node
/// before.
namespace proskill::verify {

void Explorer::saveIfDue() {
  if (checkpoint && checkpoint->isDue()) save();
}

void Explorer::save() {
  if (!checkpoint || hasOneThread || !isWhole || !result.failure.empty()) return;
  checkpoint->save([this](CheckpointWriter& to) { write(to); });
}

void Explorer::write(CheckpointWriter& to) const {
  writeGoals(to);
  writeSignatures(to);
  const ZoneStore& all = graph.timing.zones();
  ZoneRanks zones(all.size());
  for (NodeIndex i = 0; i < graph.size(); ++i) zones.insert(graph.zoneOf(i));
  zones.count();
  to.number(zones.size());
  for (ZoneId i = 0; i < all.size() && !to.hasFailed(); ++i)
    if (zones.contains(i)) writeZone(to, all.dimension(i), all.matrix(i));
  to.number(result.statistics.transitions);
  to.number(graph.size());
  to.number(frontier.takenCount() - (isHalfway ? 1 : 0));
  writeNodes(to, zones);
}

void Explorer::writeGoals(CheckpointWriter& to) const {
  for (std::size_t i = 0; i < goals.goals.size(); ++i) {
    to.number(goals.found[i] ? 1 : 0);
    if (goals.found[i]) writeSteps(to, *result.goals[i]);
  }
}

void Explorer::writeSignatures(CheckpointWriter& to) const {
  const Timing& timing = graph.timing;
  to.number(timing.signatureCount());
  for (SignatureId i = 0; i < timing.signatureCount(); ++i) {
    to.number(timing.at(i).urgent ? 1 : 0);
    writeSteps(to, timing.at(i).enabled);
  }
}

void Explorer::writeNodes(CheckpointWriter& to, const ZoneRanks& zones) const {
  std::vector<Word> before(system.storedWords);
  std::vector<Word> state(system.storedWords);
  NodeIndex parent = 0;
  StateId states = 0;
  for (NodeIndex i = 0; i < graph.size() && !to.hasFailed(); ++i) {
    const NodeIndex from = i == 0 ? 0 : graph.parentOf(i);
    if (i == 1 || from != parent) graph.states.read(graph.stateOf(from), before.data());
    const StateId reached = graph.stateOf(i);
    to.number(std::uint64_t{from - parent} << 1 | (reached == states ? 1 : 0));
    parent = from;
    if (!system.clocks.empty()) {
      to.number(zones.rank(graph.zoneOf(i)));
      to.number(graph.stepTo(i) + 1U);
    }
    if (reached != states) {
      to.number(states - 1 - reached);
      continue;
    }
    ++states;
    to.number(graph.signatureOf(reached));
    graph.states.read(reached, state.data());
    writeState(to, before.data(), state.data(), system.storedWords);
  }
}

/// \throw LimitMet
void Explorer::resume(CheckpointReader& from) {
  readGoals(from);
  readSignatures(from);
  readZones(from);
  result.statistics.transitions = from.number();
  readNodes(from);
  result.failure = checkpoint->endEarlier(graph.size());
  if (!result.failure.empty()) return;
  isWhole = true;
  for (std::size_t i = 0; i < goals.goals.size(); ++i)
    if (goals.found[i] && onFound) onFound(i, *result.goals[i]);
}

void Explorer::readGoals(CheckpointReader& from) {
  for (std::size_t i = 0; i < goals.goals.size(); ++i) {
    if (!from.flag()) continue;
    result.goals[i] = readSteps(from, system.transitions.size());
    goals.found[i] = true;
    ++goals.closed;
    --open;
  }
}

void Explorer::readSignatures(CheckpointReader& from) {
  const auto count = from.number();
  for (std::uint64_t i = 0; i < count && !from.hasFailed(); ++i) {
    const bool isUrgent = from.flag();
    TransitionSet enabled(graph.enabling.urgentOnes().size());
    for (const auto transition : readSteps(from, system.transitions.size())) {
      if (system.transitions[transition].clock == kNone) return from.fail();
      insert(enabled, transition);
    }
    if (graph.timing.signature(isUrgent, enabled, enabled) != i) from.fail();
  }
}

void Explorer::readZones(CheckpointReader& from) {
  const auto most = static_cast<std::uint32_t>(system.clocks.size() + 1);
  const auto count = from.number();
  for (std::uint64_t i = 0; i < count && !from.hasFailed(); ++i) {
    limits.check();
    const auto zone = readZone(from, most);
    if (zone && graph.timing.adopt(*zone) != i) from.fail();
  }
}

void Explorer::readNodes(CheckpointReader& from) {
  const auto count = from.indexBelow(kNone);
  const auto expanded = from.indexBelow(std::uint64_t{count} + 1);
  stored.assign(system.storedWords, 0); // the state of the node before the one that is read
  constexpr NodeIndex kBetweenChecks = 64;
  for (NodeIndex i = 0; i < count && readNode(from); ++i)
    if (i % kBetweenChecks == 0) limits.checkGrowth(graph.growth());
  if (frontier.takenCount() > expanded) from.fail();
  while (!from.hasFailed() && frontier.takenCount() < expanded) graph.expand(frontier.take());
}

/// \return whether it is valid
bool Explorer::readNode(CheckpointReader& from) {
  const auto link = from.number();
  NodeIndex parent = frontier.takenCount() == 0 ? 0 : frontier.takenCount() - 1;
  if (graph.size() > 0 && link >> 1 >= graph.size() - parent) return from.fail(), false;
  const bool isNew = (link & 1) != 0;
  parent += static_cast<NodeIndex>(link >> 1);
  if (graph.size() > 0)
    while (frontier.takenCount() <= parent) graph.expand(frontier.take());
  ZoneId zone = 0;
  TransitionId step = kNone;
  if (!system.clocks.empty()) {
    zone = from.indexBelow(graph.timing.zones().size());
    step = from.indexBelow(system.transitions.size() + 1) - 1U;
  }
  StateId state = graph.states.size();
  if (!isNew) {
    state -= 1 + from.indexBelow(state);
  } else {
    const SignatureId signature = from.indexBelow(graph.timing.signatureCount());
    if (graph.size() > 0) graph.states.read(graph.stateOf(parent), stored.data());
    readState(from, stored.data(), system.storedWords);
    if (from.hasFailed() || !isState(system, stored.data()) ||
        !graph.states.add(stored.data()).isNew)
      return from.fail(), false;
    graph.addState(signature);
  }
  return addSaved(from, state, zone, step);
}

bool Explorer::addSaved(CheckpointReader& from, StateId state, ZoneId zone, TransitionId step) {
  if (from.hasFailed()) return false;
  const auto clocks = graph.timing.at(graph.signatureOf(state)).clocks.size();
  if (zone >= graph.timing.zones().size() || graph.timing.zones().dimension(zone) != clocks + 1)
    return from.fail(), false;
  graph.addNode(state, zone, step, reductions.inclusion);
  frontier.add(stored.data(), step);
  return true;
}

} // namespace proskill::verify
