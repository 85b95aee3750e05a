#include "verify/ranks/shared_search.h"

#include "verify/progress/graph_nodes.h"
#include "verify/progress/progress_check.h"
#include "verify/ranks/rank_explorer.h"
#include "verify/reduce/free_inputs.h"

#include <algorithm>

namespace proskill::verify {

namespace {

constexpr auto kNotReal = "no run leads there";

/// A search for moments at which time can stop, in what all ranks have explored.
class SharedProgressCheck {
public:
  SharedProgressCheck(const Prepared& of, const std::vector<Goal>& asked, LimitWatch& watch,
                      Ranks& shared)
      : prepared(of), goals(asked), limits(watch), ranks(shared) {}

  /// The same on all ranks, but the evidence is that of rank 0. \throw LimitMet
  [[nodiscard]] std::optional<Evidence> find(RankExplorer& explorer, Extrapolation extrapolation) {
    const auto stuck = firstStuck(explorer);
    if (!stuck) return std::nullopt;
    Evidence evidence;
    const std::string problem =
        problemWith(evidence, *stuck, explorer, extrapolation == Extrapolation::LowerUpper);
    const std::string said = ranks.gather(problem)[0];
    if (said == kNotReal) return findFiner();
    if (!said.empty()) throw LimitMet{said};
    return evidence;
  }

private:
  /// A moment that some rank has found.
  struct Stuck {
    NodePlace place;
    std::vector<ClockRange> clocks;
    std::vector<Word> state;
  };

  /// Repeats the search with finer zones. It is not counted: whether it is needed depends on the
  /// moment that was found first, and so on the number of ranks.
  std::optional<Evidence> findFiner() {
    std::vector<Goal> stuckGoals;
    std::ranges::copy_if(goals, std::back_inserter(stuckGoals),
                         [](const Goal& goal) { return goal.kind == GoalKind::Stuck; });
    RankExplorer finer(prepared.system, stuckGoals, prepared.reductions, Extrapolation::Maximum,
                       limits, ranks, {});
    const Explored again = finer.run();
    auto stuck = find(finer, Extrapolation::Maximum);
    if (!stuck && !again.statistics.complete) throw LimitMet{again.statistics.stopped};
    return stuck;
  }

  /// What the first rank says that has found something.
  std::optional<Stuck> firstStuck(RankExplorer& explorer) {
    std::string stopped;
    const auto texts = ranks.gather(ownStuck(explorer, stopped));
    for (unsigned rank = 0; rank < texts.size(); ++rank)
      if (!texts[rank].empty()) return read(rank, readerOf(texts[rank]));
    if (auto limit = firstOf(ranks.gather(stopped)); !limit.empty())
      throw LimitMet{std::move(limit)};
    return std::nullopt;
  }

  /// What this rank has found, as bytes; empty if that is nothing.
  std::string ownStuck(RankExplorer& explorer, std::string& stopped) {
    try {
      GraphNodes nodes(explorer.explored());
      ProgressCheck check(prepared.system, prepared.reductions, nodes, limits);
      const auto found = check.find();
      stopped = check.stopped();
      if (found) return bytesOf([&](CheckpointWriter& to) { write(to, *found); });
    } catch (const LimitMet& limit) {
      stopped = limit.which;
    }
    return "";
  }

  static void write(CheckpointWriter& to, const StuckMoment& stuck) {
    to.number(stuck.node);
    to.number(stuck.clocks.size());
    for (const auto& range : stuck.clocks) {
      to.number(range.clock);
      to.signedNumber(range.lower);
      to.signedNumber(range.upper);
    }
    to.number(stuck.state.size());
    for (const auto word : stuck.state) to.number(word);
  }

  static Stuck read(unsigned rank, CheckpointReader from) {
    Stuck stuck{{rank, static_cast<NodeIndex>(from.number())}, {}, {}};
    for (auto left = from.number(); left > 0; --left) {
      ClockRange range{static_cast<ClockId>(from.number())};
      range.lower = static_cast<Bound>(from.signedNumber());
      range.upper = static_cast<Bound>(from.signedNumber());
      stuck.clocks.push_back(range);
    }
    for (auto left = from.number(); left > 0; --left) stuck.state.push_back(from.number());
    return stuck;
  }

  /// Makes the evidence. \return a limit, or kNotReal; empty if there is no problem
  std::string problemWith(Evidence& evidence, const Stuck& stuck, RankExplorer& explorer,
                          bool isDoubtful) {
    try {
      auto reached = explorer.pathTo(stuck.place);
      evidence = {std::move(reached.steps), stuck.clocks};
      if (const auto* inputs = prepared.reductions.freeInputs) {
        reached.state.resize(prepared.system.words);
        append(evidence.steps, inputs->between(reached.state.data(), stuck.state.data()));
      }
      // Extra+LU may put clocks nearer to their upper bounds than they get
      const bool isJudge = isDoubtful && ranks.self() == 0;
      return isJudge && !isReal(prepared.system, evidence, limits) ? kNotReal : "";
    } catch (const LimitMet& limit) {
      return limit.which;
    }
  }

  const Prepared& prepared;
  const std::vector<Goal>& goals;
  LimitWatch& limits;
  Ranks& ranks;
};

} // namespace

SearchResult searchByRanks(const Prepared& prepared, const std::vector<Goal>& goals,
                           LimitWatch& limits, Ranks& ranks, const OnEvidence& onFound) {
  SearchResult result;
  result.goals.resize(goals.size());
  const auto note = [&](std::size_t goal, const Evidence& evidence) {
    if (ranks.self() != 0) return;
    result.goals[goal] = evidence;
    onFound(goal, evidence);
  };
  RankExplorer explorer(prepared.system, goals, prepared.reductions, prepared.extrapolation, limits,
                        ranks, [&](std::size_t goal, const Steps& steps) {
                          note(goal, Evidence{steps, {}});
                        });
  const Explored explored = explorer.run();
  result.statistics = explored.statistics;
  if (!explored.failure.empty())
    result.failure = Unsupported{explored.failure, explored.failureOrigin};
  const auto isStuckGoal = [](const Goal& goal) { return goal.kind == GoalKind::Stuck; };
  if (result.failure || std::ranges::none_of(goals, isStuckGoal)) return result;
  try {
    SharedProgressCheck check(prepared, goals, limits, ranks);
    const auto stuck = check.find(explorer, prepared.extrapolation);
    for (std::size_t i = 0; stuck && i < goals.size(); ++i)
      if (isStuckGoal(goals[i])) note(i, *stuck);
  } catch (const LimitMet& limit) {
    result.progressStopped = limit.which;
  }
  result.statistics.seconds = limits.seconds();
  return result;
}

} // namespace proskill::verify
