#pragma once

#include "verify/explore/search.h"
#include "verify/sample/chance_run.h"
#include "verify/sample/goal_index.h"
#include "verify/sample/new_values.h"

#include <functional>
#include <vector>

namespace proskill::verify {

/// Looks for goals by runs in which chance decides. A step costs about a microsecond and nothing
/// is stored for it, so many long runs take the time of a short search. What a mission does
/// after hundreds of steps is found so, if it does not need rare coincidences.
///
/// - Each run has odds of its own: in some, failures or events are rare, in others frequent. The
///   odds of runs that found something new are used again, with changes.
/// - Most runs go on from a moment where another one found something new: Ecoffet, Huizinga,
///   Lehman, Stanley, Clune, "First return, then explore", Nature 590, 2021.
///
/// The runs are the same each time.
class RandomRuns {
public:
  /// Receives a goal, by its index, and a run that reaches it. \return whether it was confirmed
  using OnFound = std::function<bool(std::size_t, const Evidence&)>;

  /// \param of with every cell kept, without priorities \param with its enabled transitions, none
  /// skipped
  /// \param all goals \param which those to look for, by index
  /// \pre the arguments outlive this
  RandomRuns(const System& of, const Enabling& with, const std::vector<Goal>& all,
             const std::vector<std::size_t>& which, LimitWatch& watch);

  /// Looks for goals until so many steps in a row, and as many as half of all before, have reached
  /// none.
  /// \throw LimitMet
  void search(std::uint64_t patience, const OnFound& onFound);

private:
  /// Where a run found something new.
  struct Discovery {
    RunMoment moment;
    std::size_t from = SIZE_MAX; ///< the discovery before it; SIZE_MAX: the start
    Steps steps;                 ///< since then
    std::uint32_t uses = 0;      ///< lately, without finding anything
  };

  void begin();
  void run(const OnFound& onFound);
  void walk(const OnFound& onFound);
  [[nodiscard]] Odds drawOdds();
  [[nodiscard]] double drawWeight();
  [[nodiscard]] std::size_t pickDiscovery();
  [[nodiscard]] bool isBetter(std::size_t one, std::size_t other) const;
  void note(TransitionId step);
  [[nodiscard]] const RunMoment& beginning() const;
  void discover();
  void show(const std::vector<std::size_t>& reached, const OnFound& onFound);
  [[nodiscard]] bool isIdle();
  void keepOdds();
  [[nodiscard]] Steps stepsSoFar() const;

  const System& system;
  LimitWatch& limits;
  GoalIndex goals;
  NewValues values;
  ChanceRun chance;
  ChanceRun direct; ///< repeats runs without their detours
  RunMoment start;
  ChanceRun::Random random;
  double longestTime = 1; ///< the largest bound of an interval, in ticks

  std::size_t mostDiscoveries = 0;
  std::vector<Discovery> discoveries;
  std::vector<Odds> fruitful; ///< those of runs that found something new
  // the current run
  Odds odds;
  std::size_t begun = SIZE_MAX; ///< the discovery where it began; SIZE_MAX: at the start
  std::size_t from = SIZE_MAX;  ///< its last discovery, or the same
  Steps steps;                  ///< since then
  std::size_t length = 0;       ///< in steps, from where it began
  bool foundNew = false;
  std::vector<std::uint64_t> visited; ///< hashes of its states, in a table of fixed size
  std::uint32_t repeated = 0;         ///< how many of its last states it had visited before

  std::uint64_t taken = 0;    ///< number of steps of all runs
  std::uint64_t lastFind = 0; ///< and when a goal was reached the last time
};

} // namespace proskill::verify
