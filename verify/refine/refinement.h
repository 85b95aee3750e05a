#pragma once

#include "verify/answer_store.h"
#include "verify/explore/search.h"
#include "verify/guide/goal_distance.h"
#include "verify/reduce/prepared.h"
#include "verify/refine/plan_search.h"
#include "verify/refine/precision.h"
#include "verify/refine/progress_proof.h"
#include "verify/refine/refined_slice.h"
#include "verify/refine/run_proof.h"
#include "verify/refine/split_tests.h"
#include "verify/slice/part_text.h"
#include "verify/slice/slicer.h"
#include "verify/slice/whole_run.h"
#include "verify/verify.h"

#include <deque>
#include <functional>
#include <map>
#include <optional>

namespace proskill::verify {

/// Answers questions by slices that begin small and grow until they decide. Such a slice omits
/// conditions on cells that it does not know, and at first time, as if anything else might happen:
/// so what never happens in it never happens. A run of the slice that is none of the whole says
/// which cells to add. Questions about nearly the same part are asked together. Kurshan,
/// "Computer-aided verification of coordinating processes", 1994; Clarke, Grumberg, Jha, Lu, Veith,
/// "Counterexample-guided abstraction refinement", CAV 2000.
class Refinement {
public:
  using Takes = ProgressProof::Takes;
  /// Receives a goal, by its index, and a run of the whole system that reaches it; null: it is
  /// never reached.
  /// \return whether the run was confirmed
  using OnDecided = std::function<bool(std::size_t, const Evidence*)>;

  /// What the searches may cost, in classes. A slice that is made costs some, too.
  struct Budget {
    std::uint64_t together = 0; ///< it grows with each question that is decided
    std::uint64_t each = 0;     ///< for one question
  };

  /// \param system without a state layout, and without priorities
  /// \param whole the same with every cell kept
  /// \param takes whether a reduction may be used
  /// \param store keeps what never happens in slices; may be null
  /// \pre the arguments outlive this
  /// \throw LimitMet
  Refinement(const System& system, const System& whole, const fiacre::Provenance& provenance,
             Takes takes, LimitWatch& limits, AnswerStore* store);

  /// \param open the goals to decide, by index
  /// \param statistics counts the explorations
  /// \return those that were decided
  /// \throw LimitMet
  [[nodiscard]] Bits decide(const std::vector<Goal>& goals, const std::vector<std::size_t>& open,
                            Budget budget, Exploration& statistics, const OnDecided& onDecided);
  /// Whether it is shown that time can always go on.
  /// \pre no step of the system fails
  /// \throw LimitMet
  [[nodiscard]] bool showProgress(Budget budget, Exploration& statistics);
  /// Whether it is shown that no run is one that the goal's monitor accepts.
  /// \pre RunProof::isFor(goal)
  /// \param most number of classes \throw LimitMet
  [[nodiscard]] bool showNoRun(const Goal& goal, std::uint64_t most, Exploration& statistics);

private:
  /// Questions that are asked together of slices of the same precision.
  struct Group {
    Precision precision;
    std::vector<std::size_t> goals; ///< by index
    bool isWide = false;            ///< it also knows what is like that which its runs lacked
  };
  /// What slices of one kind were good for.
  struct Gain {
    std::size_t decided = 0;
    std::size_t failed = 0;
    /// Whether more of them are not worth their time.
    [[nodiscard]] bool fails() const { return failed > decided + 1; }
  };
  /// A call of decide().
  struct Asking {
    const std::vector<Goal>& goals;
    PlanSearch& plans;
    Exploration& statistics;
    const OnDecided& onDecided;
    std::uint64_t each;              ///< budget of a question
    std::uint64_t together;          ///< classes left for all questions
    std::vector<std::uint64_t> left; ///< classes left for slices, by goal
    std::vector<std::uint64_t> leftForPlans;
    std::deque<Group> groups{}; ///< to explore
    Bits decided{};
    Gain narrow{}; ///< of refined slices
    Gain wide{};

    [[nodiscard]] Gain& gainOf(const Group& group) { return group.isWide ? wide : narrow; }
  };

  void addGroups(const std::vector<std::size_t>& open, Asking& asking);
  void explore(const Group& group, Asking& asking);
  void dropKnown(const PartText& text, Group& group, Asking& asking);
  [[nodiscard]] SearchResult searchFor(const Group& group, const System& part,
                                       const Prepared& prepared, Asking& asking);
  [[nodiscard]] SearchResult searchFor(const Group& group, const Prepared& prepared,
                                       const Reductions& reductions, GoalDistance* distance,
                                       std::uint64_t most, Asking& asking);
  [[nodiscard]] std::optional<SearchResult> searchHulls(const Group& group,
                                                        const Prepared& prepared, Asking& asking);
  void readRuns(const Group& group, RefinedSlice& slice, const Prepared& prepared,
                const SearchResult& found, Asking& asking);
  [[nodiscard]] bool isDecidedBy(const Steps& steps, std::size_t goal, const Group& group,
                                 RefinedSlice& slice, Asking& asking);
  static void addWide(const Group& refined, Asking& asking);
  void giveUp(std::size_t goal, const Group& group, Asking& asking);
  [[nodiscard]] const AlikeCells& alikeCells();
  void follow(const Steps& plan, std::size_t goal, Asking& asking);
  static void note(std::size_t goal, const Evidence* run, Asking& asking);
  [[nodiscard]] static std::uint64_t mostFor(const Group& group, const Asking& asking);
  static void payForPlan(std::uint64_t classes, std::size_t goal, Asking& asking);
  static void pay(std::uint64_t classes, const Group& group, Asking& asking);
  [[nodiscard]] static std::vector<Goal> goalsOf(const Group& group, const Asking& asking);
  [[nodiscard]] Steps inSystem(const Slice& slice, const Steps& steps) const;
  [[nodiscard]] WholeRun inWhole(RefinedSlice& slice, const Steps& steps,
                                 std::size_t mostOfPlan) const;

  SplitSystem split;
  Slicer slicer; ///< of the split system
  const System& system;
  const System& whole;
  const fiacre::Provenance& provenance;
  Takes takes;
  LimitWatch& limits;
  AnswerStore* store;
  std::map<std::size_t, Bits> cones; ///< by goal: of its first slice
  std::optional<AlikeCells> alike;   ///< once they are needed
};

} // namespace proskill::verify
