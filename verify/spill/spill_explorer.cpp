#include "verify/spill/spill_explorer.h"

#include "verify/explore/conclude.h"
#include "verify/reduce/live_variables.h"

#include <algorithm>

namespace proskill::verify {

namespace {

// shares of the memory; CandidateRuns has another
constexpr std::uint64_t kShareOfReached = 6;
constexpr std::uint64_t kShareOfTiming = 4;
constexpr std::uint64_t kShareOfLiveVariables = 16;

SpillFormat formatOf(const Prepared& prepared) {
  return {.words = prepared.system.storedWords,
          .hasZones = !prepared.system.clocks.empty(),
          .hasDiscoveries = true,
          .inclusion = prepared.reductions.inclusion};
}

} // namespace

SpillExplorer::SpillExplorer(const Prepared& prepared, Extrapolation how,
                             const std::vector<Goal>& asked, std::vector<bool> known,
                             LimitWatch& watch, SpillSpace& in, OnFound tell)
    : system(prepared.system),
      reductions(prepared.reductions),
      limits(watch),
      space(in),
      onFound(std::move(tell)),
      graph(system, reductions.dropped, how),
      walker(system, graph.enabling, reductions),
      goals{asked, std::move(known), 0},
      expander(system, goals, reductions, graph, graph.timing, watch),
      pathSteps(system, reductions, walker, expander),
      format(formatOf(prepared)),
      candidates(in, format, graph.timing.zones()),
      visited(in, format),
      reached(in, in.memoryBytes() / kShareOfReached),
      nodes(in, format) {
  result.goals.resize(asked.size());
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const bool isOpen = asked[i].kind != GoalKind::Unsupported && asked[i].kind != GoalKind::Run;
    if (goals.found[i]) ++goals.closed;
    if (isOpen && !goals.found[i]) ++open;
  }
}

Progress SpillExplorer::progress() const {
  return {nodes.size(),
          visited.states(),
          nodes.size() - first,
          graph.bytes() + candidates.bytes() + visited.bytes() + reached.bytes() + nodes.bytes(),
          limits.seconds(),
          goals.goals.size() - open,
          goals.goals.size()};
}

Explored SpillExplorer::run() {
  exploreWithinLimits(result.statistics, [this] { explore(); });
  result.limited = !result.statistics.stopped.empty();
  exploreWithinLimits(result.statistics, [this] { conclude(); });
  return std::move(result);
}

/// \throw LimitMet
void SpillExplorer::explore() {
  start();
  for (settle(); first < nodes.size() && !isOver(); settle()) expandLevel();
}

void SpillExplorer::start() {
  expander.start(work);
  if (reductions.liveVariables)
    for (const auto& it : work.successors)
      reductions.liveVariables->clean(work.words.data() + it.state);
  store();
}

/// Makes nodes of the candidates that are new.
void SpillExplorer::settle() {
  candidates.writeRun();
  visited.add(candidates, [this](const StateGroup& group, std::size_t zone) {
    reached.add(group.discoveries[zone].order, nodes.textOf(group, zone));
  });
  reached.each([this](std::string_view text) { nodes.add(text); });
}

/// \throw LimitMet
void SpillExplorer::expandLevel() {
  constexpr std::uint64_t kBetweenChecks = 8;
  const std::uint64_t end = nodes.size();
  NodeFile::Reader reader(nodes, first);
  SpilledNode node;
  for (; first < end && !isOver(); ++first) {
    if (first % kBetweenChecks == 0)
      if (auto limit = limits.met(progress()); !limit.empty()) throw LimitMet{std::move(limit)};
    reader.next(node);
    expanding = first + 1;
    expand(node);
  }
}

void SpillExplorer::expand(const SpilledNode& node) {
  forgetIfMany();
  loadState(node.state);
  expander.load(node.state.data(), signature, graph.timing.adopt(node.zone));
  expander.expand(work);
  if (reductions.liveVariables)
    for (const auto& it : work.successors)
      reductions.liveVariables->clean(work.words.data() + it.state);
  store();
}

/// What is remembered to save time must not fill the memory.
void SpillExplorer::forgetIfMany() {
  const Timing& timing = graph.timing;
  const std::uint64_t bytes = timing.bytes() + timing.growth() + timing.signatureBytes();
  if (bytes > space.memoryBytes() / kShareOfTiming) forget();
  const auto* live = reductions.liveVariables;
  if (live && live->rememberedBytes() > space.memoryBytes() / kShareOfLiveVariables) live->forget();
}

/// Removes all zones and signatures. Nobody needs their numbers between two nodes.
void SpillExplorer::forget() {
  candidates.writeRun(); // which has zones by their numbers
  graph.timing.forget();
  expander.forgetLoaded();
  whole.clear();
}

/// Keeps what was found from the node that is expanded.
void SpillExplorer::store() {
  for (const auto& notice : work.notices) found(notice);
  result.statistics.transitions += work.transitions;
  if (!work.failure.empty()) {
    result.failure = work.failure;
    result.failureOrigin = work.failureOrigin;
    return;
  }
  for (const auto& it : work.successors)
    candidates.add(work.words.data() + it.state, it.zone, {expanding, arrivals++, it.transition});
}

void SpillExplorer::found(const Notice& notice) {
  if (goals.found[notice.goal]) return;
  Steps steps;
  if (expanding != 0) steps = pathTo(expanding - 1);
  append(steps, notice.steps);
  goals.found[notice.goal] = true;
  ++goals.closed;
  --open;
  result.goals[notice.goal] = std::move(steps);
  if (onFound) onFound(notice.goal, *result.goals[notice.goal]);
}

/// \throw LimitMet
void SpillExplorer::conclude() {
  auto& statistics = result.statistics;
  verify::conclude(statistics, first == nodes.size(), result.failure, "all questions decided");
  statistics.classes = nodes.size();
  statistics.markings = visited.states();
  statistics.bytes = progress().bytes;
  statistics.seconds = limits.seconds();
  candidates.release();
  if (!result.limited) statistics.domains = countDomains();
  reached.release();
  statistics.spilledBytes = space.peakOnDisk();
}

/// The number of distinct zones of the nodes.
std::uint64_t SpillExplorer::countDomains() {
  if (!format.hasZones) return nodes.size() == 0 ? 0 : 1;
  forget();
  std::uint64_t count = 0;
  SpilledNode node;
  NodeFile::Reader reader(nodes, 0);
  for (std::uint64_t i = 0; i < nodes.size(); ++i) {
    forgetIfMany();
    reader.next(node);
    const ZoneId known = graph.timing.zones().size();
    if (graph.timing.adopt(node.zone) != known) continue;
    const auto matrix = node.zone.matrix();
    reached.add(0, {reinterpret_cast<const char*>(matrix.data()), matrix.size_bytes()});
  }
  reached.each([&](std::string_view) { ++count; });
  return count;
}

void SpillExplorer::loadState(const std::vector<Word>& state) {
  if (!whole.empty() && std::ranges::equal(state, std::span(whole).first(state.size()))) return;
  whole = state;
  whole.resize(system.words);
  graph.enabling.compute(whole.data(), enabled);
  signature = walker.signature(whole, enabled, graph.timing);
}

PathNode SpillExplorer::placeOf(const SpilledNode& node) {
  loadState(node.state);
  return {node.state, signature, graph.timing.adopt(node.zone), node.step};
}

Steps SpillExplorer::pathTo(std::uint64_t node) {
  std::vector<SpilledNode> line{nodes.at(node)};
  while (line.back().parent != 0) line.push_back(nodes.at(line.back().parent - 1));
  Steps path = pathSteps.toFirst();
  for (std::size_t i = line.size(); i-- > 1;)
    append(path, pathSteps.between(placeOf(line[i]), placeOf(line[i - 1])));
  append(path, pathSteps.atEnd(line.front().state));
  return path;
}

} // namespace proskill::verify
