#pragma once

#include "verify/refine/precision.h"
#include "verify/refine/step_cycles.h"

#include <functional>

namespace proskill::verify {

/// Shows that time can always go on, one instance after the other: where time has stopped for ever,
/// urgent steps repeat, so some instance moves in a cycle without time passing. A slice in which it
/// cannot do so shows that it is not this one. docs/verification.md has the argument.
class ProgressProof {
public:
  using Takes = std::function<bool(Reduction)>;

  /// \param slicer of a system without priorities in which no step fails
  /// \param takes whether a reduction may be used
  /// \pre the arguments outlive this
  ProgressProof(Slicer& slicer, const Takes& takes, LimitWatch& limits);

  /// \param together how many classes the searches may have, and \param each those for one instance
  /// \param statistics counts the explorations
  /// \return whether time can always go on; false: it is not known
  /// \throw LimitMet
  [[nodiscard]] bool run(std::uint64_t together, std::uint64_t each, Exploration& statistics);

private:
  enum class Outcome : std::uint8_t {
    Shown,
    Refined, ///< the next slice knows more
    GaveUp,
  };

  void findRepeating();
  [[nodiscard]] Bits instancesOf(const Bits& steps) const;
  [[nodiscard]] Bits stepsOf(InstanceId instance) const;
  bool settle(InstanceId instance, std::uint64_t& left, Exploration& statistics);
  Outcome explore(InstanceId instance, const Slice& slice, Precision& precision,
                  std::uint64_t& left, Exploration& statistics);
  void settleOthers(const Slice& slice, const Bits& moving);
  [[nodiscard]] bool takesPart(TransitionId step, InstanceId instance) const;

  Slicer& slicer;
  const Takes& takes;
  LimitWatch& limits;
  const System& system; ///< the slicer's, with its layout
  Bits excluded;        ///< steps that do not repeat without time passing, for all that is shown
  Bits repeating;       ///< those that perhaps do
};

} // namespace proskill::verify
