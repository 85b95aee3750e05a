#pragma once

#include "verify/explore/search.h"
#include "verify/reduce/prepared.h"
#include "verify/trace/witness.h"

#include <functional>
#include <optional>
#include <vector>

namespace proskill::verify {

/// Searches the whole system along plans: runs of slices that are none of the whole, because
/// others are in the way for a while. Such a search looks for all goals at once, since a long run
/// shows much on its way. The whole is prepared once for all plans.
class PlanSearch {
public:
  using Takes = std::function<bool(Reduction)>;
  /// Receives a goal, by its index, and a run that reaches it. \return whether it was confirmed
  using OnDecided = std::function<bool(std::size_t, const Evidence*)>;

  /// \param system without a state layout, and without priorities
  /// \param whole the same with every cell kept
  /// \param goals all goals \param open those to look for, by index
  /// \pre the arguments outlive this
  PlanSearch(const System& system, const System& whole, const fiacre::Provenance& provenance,
             const Takes& takes, LimitWatch& limits, const std::vector<Goal>& goals,
             std::vector<std::size_t> open);

  /// \param plan steps of the system
  /// \param left number of classes that searches may still find; a search along a plan finds
  /// several in the time of one
  /// \param decided receives those that were decided; these are not looked for
  /// \throw LimitMet
  void follow(const Steps& plan, std::uint64_t& left, Bits& decided, Exploration& statistics,
              const OnDecided& onDecided);

private:
  void prepare();

  const System& system;
  const System& whole;
  const fiacre::Provenance& provenance;
  const Takes& takes;
  LimitWatch& limits;
  const std::vector<Goal>& goals;
  std::vector<std::size_t> open;
  // The next search has so many classes, and so many for each step; fewer after each that decided
  // nothing.
  std::uint64_t size;
  std::uint64_t perStep;
  std::optional<Prepared> prepared; ///< once there is a plan
  std::optional<Witness> witness;
};

} // namespace proskill::verify
