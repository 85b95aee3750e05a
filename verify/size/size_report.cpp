#include "verify/size/size_report.h"

#include "verify/compile/compile.h"
#include "verify/explore/explorer.h"
#include "verify/reduce/monitor_view.h"
#include "verify/reduce/prepared.h"
#include "verify/state/evaluate.h"

#include <algorithm>
#include <map>

namespace proskill::verify {

namespace {

std::uint64_t hashOf(std::uint64_t place, std::uint64_t value) {
  return mix(mix(0x9e3779b97f4a7c15, place), value);
}

std::uint64_t countDistinct(std::vector<std::uint64_t>& hashes) {
  std::ranges::sort(hashes);
  return static_cast<std::uint64_t>(std::ranges::unique(hashes).begin() - hashes.begin());
}

/// Splits the hash of each class into the shares of the parts. A hash is a sum over cells and
/// bounds of clocks, so the classes without a part have the hash without its share.
class Shares {
public:
  Shares(const System& of, const std::vector<SizeCell>& cells, const ZoneGraph& explored,
         const std::function<std::string(const SizeCell&)>& partOf)
      : system(of), graph(explored) {
    for (const auto& cell : cells) ofCell.push_back(number(partOf(cell)));
    for (const auto& clock : of.clocks)
      ofClock.push_back(ofCell[system.instances[ownerOf(clock)].location]);
    runs.resize(of.clocks.size());
    within.resize(names.size());
    without.resize(names.size());
    state.resize(of.words);
  }

  void add(NodeIndex node) {
    const StateId id = graph.stateOf(node);
    graph.states.read(id, state.data());
    std::vector<std::uint64_t> shares(names.size());
    std::uint64_t sum = 0;
    for (CellId cell = 0; cell < ofCell.size(); ++cell) {
      const auto value = static_cast<std::uint64_t>(readCell(system, cell, state.data()));
      const auto hash = hashOf(cell, value);
      sum += hash;
      shares[ofCell[cell]] += hash;
    }
    for (std::size_t part = 0; part < names.size(); ++part) within[part].push_back(shares[part]);
    addZone(node, shares, sum);
    for (std::size_t part = 0; part < names.size(); ++part)
      without[part].push_back(sum - shares[part]);
  }

  /// Whether the classes so far have to be enough: their hashes take some 100 MB.
  [[nodiscard]] bool isFull(std::uint64_t classes) const {
    constexpr std::uint64_t kMost = 6'000'000;
    return classes * names.size() > kMost;
  }

  std::vector<SizePart> counted(std::uint64_t classes) {
    std::vector<SizePart> all;
    for (std::size_t i = 0; i < names.size(); ++i) {
      SizePart made{.name = *names[i], .values = countDistinct(within[i])};
      for (std::size_t clock = 0; clock < runs.size(); ++clock)
        made.clocks += runs[clock] && ofClock[clock] == i ? 1 : 0;
      made.factor = static_cast<double>(classes) / static_cast<double>(countDistinct(without[i]));
      constexpr double kNothing = 1.005;
      if (made.factor > kNothing) all.push_back(std::move(made));
    }
    std::ranges::stable_sort(all, std::greater<>(), &SizePart::factor);
    return all;
  }

private:
  std::uint32_t number(std::string name) {
    const auto next = static_cast<std::uint32_t>(names.size());
    const auto [at, isNew] = numbers.emplace(std::move(name), next);
    if (isNew) names.push_back(&at->first);
    return at->second;
  }

  [[nodiscard]] InstanceId ownerOf(const Clock& clock) const {
    if (clock.instance != kNone) return clock.instance;
    return system.paths[system.transitions[clock.transition].parts[0]].instance;
  }

  /// Adds the bounds on differences of clocks, each to the shares of both.
  void addZone(NodeIndex node, std::vector<std::uint64_t>& shares, std::uint64_t& sum) {
    const auto& clocks = graph.timing.at(graph.signatureOf(graph.stateOf(node))).clocks;
    const Dbm zone = graph.timing.zones().zone(graph.zoneOf(node));
    const auto clockAt = [&](std::uint32_t i) { return i == 0 ? kNone : clocks[i - 1]; };
    for (const auto clock : clocks) runs[clock] = true;
    for (std::uint32_t i = 0; i < zone.dimension(); ++i)
      for (std::uint32_t j = 0; j < zone.dimension(); ++j) {
        if (i == j) continue;
        const auto place = std::uint64_t{1} << 63 | std::uint64_t{clockAt(i)} << 31 | clockAt(j);
        const auto hash = hashOf(place, static_cast<std::uint64_t>(zone.at(i, j)));
        sum += hash;
        if (i != 0) shares[ofClock[clockAt(i)]] += hash;
        if (j != 0 && (i == 0 || ofClock[clockAt(i)] != ofClock[clockAt(j)]))
          shares[ofClock[clockAt(j)]] += hash;
      }
  }

  const System& system;
  const ZoneGraph& graph;
  std::map<std::string, std::uint32_t> numbers;
  std::vector<const std::string*> names;           ///< by part
  std::vector<std::uint32_t> ofCell;               ///< by cell: its part
  std::vector<std::uint32_t> ofClock;              ///< by clock: its part
  std::vector<bool> runs;                          ///< by clock
  std::vector<std::vector<std::uint64_t>> within;  ///< by part, then by class
  std::vector<std::vector<std::uint64_t>> without; ///< likewise
  std::vector<Word> state;
};

std::vector<SizeCell> cellsOf(const System& system) {
  std::vector<SizeCell> cells;
  for (const auto& cell : system.cells) cells.push_back({.name = cell.name});
  for (const auto& instance : system.instances)
    cells[instance.location] = {instance.name, instance.origin, true};
  return cells;
}

/// Explores everything: none of these goals is found, except that errors are passed over.
std::vector<Goal> neverFound() { return {{.kind = GoalKind::Stuck}, {.kind = GoalKind::Error}}; }

/// Adds what a question with an exploration of its own sees of the system.
void addSeen(const Goal& goal, std::vector<Goal>& all) {
  if (goal.kind == GoalKind::Lost)
    all.push_back({.kind = GoalKind::Condition, .condition = goal.condition, .ofSteps = true});
  else
    for (auto& seen : goalsOf(goal.monitor)) all.push_back(std::move(seen));
}

} // namespace

std::expected<SizeReport, Unsupported>
explainSize(const fiacre::Program& program, const fiacre::Provenance& provenance,
            const std::vector<Question>& questions,
            const std::function<std::string(const SizeCell&)>& partOf,
            const std::function<std::string(const std::string&)>& kindOf, const Options& options) {
  LimitWatch limits(options);
  SizeReport report;
  try {
    const auto compiled = compile(program, provenance, questions, &limits);
    if (!compiled) return std::unexpected(compiled.error());
    std::vector<Goal> asked;
    for (std::size_t i = 0; i < compiled->goals.size(); ++i)
      if (hasOwnSearch(compiled->goals[i]))
        report.apart.push_back(i);
      else
        asked.push_back(compiled->goals[i]);
    if (asked.empty())
      for (const auto i : report.apart) addSeen(compiled->goals[i], asked);
    const auto takes = [&](Reduction each) { return mayTake(each, options, compiled->system); };
    const Prepared prepared(compiled->system, asked, takes, limits);
    Explorer explorer(prepared.system, neverFound(), prepared.reductions, prepared.extrapolation,
                      limits);
    const auto explored = explorer.run();
    const ZoneGraph& graph = explorer.explored();
    const auto cells = cellsOf(prepared.system);
    Shares parts(prepared.system, cells, graph, partOf);
    Shares kinds(prepared.system, cells, graph,
                 [&](const SizeCell& cell) { return kindOf(partOf(cell)); });
    for (NodeIndex node = 0; node < graph.size() && !parts.isFull(report.classes); ++node) {
      if (graph.isSubsumed(node)) continue;
      parts.add(node);
      kinds.add(node);
      ++report.classes;
    }
    report.found = explored.statistics.classes;
    report.states = graph.states.size();
    report.complete = explored.statistics.complete;
    report.stopped = explored.statistics.stopped;
    report.parts = parts.counted(report.classes);
    report.kinds = kinds.counted(report.classes);
  } catch (const LimitMet& limit) {
    report.stopped = limit.which;
  }
  return report;
}

} // namespace proskill::verify
