#pragma once

#include "verify/answer_store.h"
#include "verify/refine/precision.h"
#include "verify/refine/refined_slice.h"

#include <functional>

namespace proskill::verify {

/// Shows that no run of a system is one that a monitor accepts, by slices that begin small and grow
/// like those of Refinement. The monitor reads a run of the whole like the run of the slice that is
/// left without the other steps, so a slice without such a run is enough.
class RunProof {
public:
  using Takes = std::function<bool(Reduction)>;

  /// \param slicer of a system without priorities
  /// \param takes whether a reduction may be used
  /// \param store keeps what never happens in slices; may be null
  /// \pre the arguments outlive this
  RunProof(Slicer& slicer, const fiacre::Provenance& provenance, const Takes& takes,
           LimitWatch& limits, AnswerStore* store);

  /// Whether the question is one for slices: the monitor ignores steps that change nothing it
  /// reads.
  [[nodiscard]] static bool isFor(const Goal& goal);

  /// \param goal isFor() it
  /// \param most how many classes the searches may have
  /// \param statistics counts the explorations
  /// \return whether no run is accepted; false: it is not known
  /// \throw LimitMet
  [[nodiscard]] bool run(const Goal& goal, std::uint64_t most, Exploration& statistics);

private:
  enum class Outcome : std::uint8_t {
    Shown,
    Refined, ///< the next slice knows more
    GaveUp,
  };

  Outcome explore(const Goal& goal, const std::vector<Goal>& seen, Precision& precision,
                  std::uint64_t& left, Exploration& statistics);
  Outcome search(const Goal& goal, const std::vector<Goal>& seen, const RefinedSlice& slice,
                 Precision& precision, std::uint64_t& left, Exploration& statistics);

  Slicer& slicer;
  const fiacre::Provenance& provenance;
  const Takes& takes;
  LimitWatch& limits;
  AnswerStore* store;
};

} // namespace proskill::verify
