#include "verify/refine/run_proof.h"

#include "verify/explore/monitor_search.h"
#include "verify/laid_out.h"
#include "verify/reduce/monitor_view.h"
#include "verify/reduce/prepared.h"
#include "verify/refine/class_budget.h"
#include "verify/slice/part_text.h"
#include "verify/trace/witness.h"

#include <algorithm>
#include <string>

namespace proskill::verify {

namespace {

bool isTimed(const Monitor& monitor) {
  return std::ranges::any_of(monitor.locations, &MonitorLocation::timed);
}

} // namespace

RunProof::RunProof(Slicer& of, const fiacre::Provenance& origins, const Takes& may,
                   LimitWatch& watch, AnswerStore* answers)
    : slicer(of), provenance(origins), takes(may), limits(watch), store(answers) {}

bool RunProof::isFor(const Goal& goal) {
  return goal.kind == GoalKind::Run && watchesPoints(goal.monitor);
}

bool RunProof::run(const Goal& goal, std::uint64_t most, Exploration& statistics) {
  Goal finite = goal; // where a run is accepted, what follows does not matter
  finite.monitor.rests = goal.monitor.letsRest();
  finite.monitor.fair = false;
  const auto seen = goalsOf(finite.monitor);
  Precision precision(slicer, isTimed(finite.monitor));
  auto outcome = Outcome::Refined;
  while (outcome == Outcome::Refined) {
    spend(priceOfSlice(slicer.system()), most);
    if (most == 0) return false;
    outcome = explore(finite, seen, precision, most, statistics);
  }
  return outcome == Outcome::Shown;
}

RunProof::Outcome RunProof::explore(const Goal& goal, const std::vector<Goal>& seen,
                                    Precision& precision, std::uint64_t& left,
                                    Exploration& statistics) {
  const RefinedSlice slice(precision, seen, limits);
  const auto name = store ? PartText(slice.part()).with(goal) : std::string();
  if (store && store->isNeverIn(name)) return Outcome::Shown;
  const auto outcome = search(goal, seen, slice, precision, left, statistics);
  if (store && outcome == Outcome::Shown) store->keepNeverIn(name);
  return outcome;
}

RunProof::Outcome RunProof::search(const Goal& goal, const std::vector<Goal>& seen,
                                   const RefinedSlice& slice, Precision& precision,
                                   std::uint64_t& left, Exploration& statistics) {
  const auto may = [&](Reduction it) {
    return takes(it) && suits(goal.monitor, it, slicer.system());
  };
  const Prepared prepared(slice.part(), seen, may, limits);
  const auto found =
      watchFor(prepared.system, goal.monitor, prepared.reductions, {}, true, limits, nullptr, left);
  addCounts(statistics, found.statistics);
  spend(found.statistics.classes, left);
  if (!found.evidence) return found.statistics.complete ? Outcome::Shown : Outcome::GaveUp;
  const System allCells = laidOutCopy(slice.part(), limits);
  const Witness witness(allCells, prepared.reductions, provenance, limits);
  const Steps steps = slice.inSlice(witness.tidied(goal, *found.evidence).steps);
  return precision.growBy(slice.uncontracted(), steps) ? Outcome::Refined : Outcome::GaveUp;
}

} // namespace proskill::verify
