#pragma once

#include "verify/graph/number_lists.h"
#include "verify/limits.h"
#include "verify/spill/item_sorter.h"
#include "verify/spill/visited_states.h"
#include "verify/state/enabled.h"
#include "verify/state/evaluate.h"
#include "verify/state/firing_domains.h"

#include <unordered_set>

namespace proskill::verify {

/// Counts state classes as ClassGraph does, with the classes on disk: see VisitedStates.
class SpilledClasses {
public:
  /// \pre the arguments outlive this
  SpilledClasses(const System& system, LimitWatch& limits, SpillSpace& space);
  SpilledClasses(const SpilledClasses&) = delete;
  SpilledClasses& operator=(const SpilledClasses&) = delete;

  std::expected<Exploration, Unsupported> run();

private:
  using Run = std::shared_ptr<const VisitedRun>;

  void explore();
  Run settle();
  void expandLevel(const VisitedRun& level);
  void expand(const StateGroup& group);
  void follow(std::uint32_t signature, TransitionId transition);
  void noteDomains();
  void noteDomain(std::uint32_t set, ZoneId domain);
  void forgetIfMany();
  void countDomains();
  [[nodiscard]] Progress progress() const;

  const System& system;
  LimitWatch& limits;
  SpillSpace& space;
  Enabling enabling;
  FiringDomains domains;
  SpillFormat format;
  CandidateRuns candidates;
  VisitedStates visited;
  ItemSorter possibleDomains; ///< with the transitions for which they hold
  Exploration result;
  Unsupported failure;

  std::vector<ZoneId> pending;         ///< the domains of the marking that is expanded
  std::vector<std::uint32_t> possible; ///< its transitions and their target locations
  // what possibleDomains is known to have:
  NumberLists possibleSets;
  std::unordered_set<std::uint64_t> noted; ///< the number of a set, and of a domain
  std::uint64_t notedBytes = 0;            ///< about, of all these
  ByteText text;
  std::vector<Word> state;
  std::vector<Word> next;
  TransitionSet enabled;
  TransitionSet nextEnabled;
  StepLog log;
};

/// Counts in memory; if that does not suffice, again on disk. \pre Options::spill is set
/// \throw LimitMet
[[nodiscard]] std::expected<Exploration, Unsupported>
countWithSpill(const System& system, LimitWatch& limits, const Options& options);

} // namespace proskill::verify
