#pragma once

#include "verify/answer_store.h"
#include "verify/explore/search.h"
#include "verify/guide/goal_distance.h"
#include "verify/reduce/prepared.h"
#include "verify/refine/plan_search.h"
#include "verify/refine/precision.h"
#include "verify/refine/progress_proof.h"
#include "verify/refine/split_tests.h"
#include "verify/slice/slicer.h"
#include "verify/verify.h"

#include <functional>
#include <optional>

namespace proskill::verify {

/// Answers questions by slices that begin small and grow until they decide. Such a slice omits
/// conditions on cells that it does not know, and at first time, as if anything else might happen:
/// so what never happens in it never happens. A run of the slice that is none of the whole says
/// which cells to add. Kurshan, "Computer-aided verification of coordinating processes", 1994;
/// Clarke, Grumberg, Jha, Lu, Veith, "Counterexample-guided abstraction refinement", CAV 2000.
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

private:
  enum class Outcome : std::uint8_t {
    Decided,
    Refined, ///< the next slice knows more
    GaveUp,
  };
  /// What is asked, and who receives the answer.
  struct Asked {
    const Goal& goal;
    std::function<bool(const Evidence*)> onDecided;
    /// Searches the whole along a run of a slice, for this goal and others.
    /// \return whether this one was decided
    std::function<bool(const Steps&, std::uint64_t& classes)> follow;
  };

  [[nodiscard]] Outcome decide(const Asked& asked, std::uint64_t& left, Exploration& statistics);
  [[nodiscard]] Outcome explore(const Asked& asked, const Slice& slice, Precision& precision,
                                std::uint64_t& left, Exploration& statistics);
  [[nodiscard]] SearchResult searchFor(const Goal& goal, const System& part,
                                       const Prepared& prepared, std::uint64_t& left,
                                       Exploration& statistics);
  [[nodiscard]] SearchResult searchFor(const Goal& goal, const Prepared& prepared,
                                       GoalDistance* distance, std::uint64_t most,
                                       std::uint64_t& left, Exploration& statistics);
  [[nodiscard]] static Outcome never(const Asked& asked);
  [[nodiscard]] Steps inSystem(const Slice& slice, const Steps& steps) const;
  [[nodiscard]] std::optional<Steps> completed(const Slice& slice, const Steps& steps);

  SplitSystem split;
  Slicer slicer; ///< of the split system
  const System& system;
  const System& whole;
  const fiacre::Provenance& provenance;
  Takes takes;
  LimitWatch& limits;
  AnswerStore* store;
};

} // namespace proskill::verify
