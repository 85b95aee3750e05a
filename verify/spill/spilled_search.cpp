#include "verify/spill/spilled_search.h"

#include "verify/progress/progress_check.h"
#include "verify/reduce/free_inputs.h"
#include "verify/spill/spill_explorer.h"

#include <algorithm>

namespace proskill::verify {

namespace {

bool isStuckGoal(const Goal& goal) { return goal.kind == GoalKind::Stuck; }

/// The limit that left something open; empty if there is none.
const std::string& limitOf(const SearchResult& result) {
  return result.limited && !result.statistics.stopped.empty() ? result.statistics.stopped
                                                              : result.progressStopped;
}

/// The nodes of a search on disk.
class SpilledNodes : public ExploredNodes {
public:
  /// \pre the arguments outlive this
  SpilledNodes(const System& of, SpillExplorer& in)
      : ExploredNodes(in.enabling(), in.timing()), system(of), explorer(in) {}

  void rewind() override {
    reader.emplace(explorer.explored(), 0);
    following = 0;
  }
  [[nodiscard]] bool next() override {
    if (following == explorer.explored().size()) return false;
    reader->next(current);
    ++following;
    if (current.state != last) describe();
    return true;
  }
  [[nodiscard]] std::uint64_t node() const override { return following - 1; }
  [[nodiscard]] std::uint64_t state() const override { return states; }
  [[nodiscard]] SignatureId signature() override { return ofState; }
  void readState(Word* to) const override { std::ranges::copy(current.state, to); }
  [[nodiscard]] Dbm zone() const override { return current.zone; }
  void forget() override {
    explorer.forget();
    describe();
  }
  [[nodiscard]] Progress progress() const override { return explorer.progress(); }
  [[nodiscard]] std::uint64_t growth() const override { return timing.growth(); }

private:
  void describe() {
    last = current.state;
    ++states;
    std::vector<Word> whole = last;
    whole.resize(system.words);
    enabling.compute(whole.data(), enabled);
    ofState = explorer.walk().signature(whole, enabled, timing);
  }

  const System& system;
  SpillExplorer& explorer;
  std::optional<NodeFile::Reader> reader;
  std::uint64_t following = 0; ///< the node after the current one
  SpilledNode current;
  std::vector<Word> last;
  std::uint64_t states = 0; ///< number of changes of the state
  SignatureId ofState = 0;
  TransitionSet enabled;
};

/// A search on disk, and the search for moments at which time can stop that may follow.
class SpilledSearch {
public:
  SpilledSearch(const Prepared& of, const std::vector<Goal>& asked, LimitWatch& watch,
                SpillStore& with, std::uint64_t bytes)
      : prepared(of), goals(asked), limits(watch), store(with), memory(bytes) {}

  /// \param known evidence by goal, where there is some
  SearchResult run(std::vector<std::optional<Evidence>> known, const OnEvidence& onFound) {
    result.goals = std::move(known);
    std::vector<bool> isFound;
    for (const auto& goal : result.goals) isFound.push_back(goal.has_value());
    const auto note = [&](std::size_t goal, const Evidence& evidence) {
      result.goals[goal] = evidence;
      onFound(goal, evidence);
    };
    SpillSpace space(store, limits, memory);
    SpillExplorer explorer(prepared, prepared.extrapolation, goals, isFound, limits, space,
                           [&](std::size_t goal, const Steps& steps) {
                             note(goal, Evidence{steps, {}});
                           });
    const Explored explored = explorer.run();
    result.statistics = explored.statistics;
    result.limited = explored.limited;
    if (!explored.failure.empty())
      result.failure = Unsupported{explored.failure, explored.failureOrigin};
    if (result.failure || std::ranges::none_of(goals, isStuckGoal)) return std::move(result);
    if (isStuckKnown()) return std::move(result);
    const auto stuck = stuckWithin(explorer);
    result.statistics.seconds = limits.seconds();
    for (std::size_t i = 0; stuck && i < goals.size(); ++i)
      if (isStuckGoal(goals[i])) note(i, *stuck);
    return std::move(result);
  }

private:
  static constexpr std::uint64_t kShareOfMoments = 4;

  [[nodiscard]] bool isStuckKnown() const {
    for (std::size_t i = 0; i < goals.size(); ++i)
      if (isStuckGoal(goals[i]) && result.goals[i]) return true;
    return false;
  }

  /// Whether time can stop. If undecided, the result says which limit was reached.
  std::optional<Evidence> stuckWithin(SpillExplorer& explorer) {
    try {
      auto stuck = find(explorer);
      // Extra+LU may put clocks nearer to their upper bounds than they get
      if (stuck && prepared.extrapolation == Extrapolation::LowerUpper &&
          !isReal(prepared.system, *stuck, limits))
        return findFiner();
      return stuck;
    } catch (const LimitMet& limit) {
      result.progressStopped = limit.which;
      return std::nullopt;
    }
  }

  /// \throw LimitMet
  std::optional<Evidence> find(SpillExplorer& explorer) {
    SpilledNodes nodes(prepared.system, explorer);
    ProgressCheck check(prepared.system, prepared.reductions, nodes, limits,
                        memory / kShareOfMoments);
    const auto stuck = check.find();
    if (!check.stopped().empty()) throw LimitMet{check.stopped()};
    if (!stuck) return std::nullopt;
    Evidence evidence{explorer.pathTo(stuck->node), stuck->clocks};
    const auto* inputs = prepared.reductions.freeInputs;
    if (!inputs) return evidence;
    std::vector<Word> stored = explorer.explored().at(stuck->node).state;
    stored.resize(prepared.system.words);
    append(evidence.steps, inputs->between(stored.data(), stuck->state.data()));
    return evidence;
  }

  /// Repeats the search with finer zones. \throw LimitMet
  std::optional<Evidence> findFiner() {
    std::vector<Goal> stuckGoals;
    std::ranges::copy_if(goals, std::back_inserter(stuckGoals), isStuckGoal);
    SpillSpace space(store, limits, memory / 2); // the first search still needs some
    SpillExplorer finer(prepared, Extrapolation::Maximum, stuckGoals,
                        std::vector<bool>(stuckGoals.size()), limits, space, {});
    const Explored again = finer.run();
    const bool complete = result.statistics.complete;
    add(result.statistics, again.statistics);
    if (complete && !again.statistics.complete) { // the other questions are decided
      result.statistics.complete = true;
      result.statistics.stopped.clear();
    }
    auto stuck = find(finer);
    if (!stuck && !again.statistics.complete) throw LimitMet{again.statistics.stopped};
    return stuck;
  }

  const Prepared& prepared;
  const std::vector<Goal>& goals;
  LimitWatch& limits;
  SpillStore& store;
  std::uint64_t memory; ///< bytes
  SearchResult result;
};

} // namespace

SearchResult searchWithSpill(const Prepared& prepared, const std::vector<Goal>& goals,
                             LimitWatch& limits, const Options& options,
                             const std::function<SearchResult()>& inMemory,
                             const OnEvidence& onFound) {
  SearchResult first;
  first.goals.resize(goals.size());
  auto bytes = options.spillBytes;
  if (!bytes) {
    first = inMemory();
    bytes = limits.bytesForDiskSearch(limitOf(first));
    if (!bytes) return first;
    limits.forgetMet();
  }
  return SpilledSearch(prepared, goals, limits, *options.spill, *bytes)
      .run(std::move(first.goals), onFound);
}

} // namespace proskill::verify
