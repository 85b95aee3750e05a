#pragma once

#include "verify/explore/search.h"
#include "verify/slice/slicer.h"
#include "verify/verify.h"

#include <functional>
#include <optional>

namespace proskill::verify {

/// Answers questions by exploring only the part of the system that each is about.
class SliceSearch {
public:
  /// Receives a goal, by its index, and a run of the whole system that reaches it; null: it is
  /// never reached.
  /// \return whether the run was confirmed
  using OnDecided = std::function<bool(std::size_t, const Evidence*)>;
  using Takes = std::function<bool(Reduction)>;

  /// \param system without a state layout, and without priorities
  /// \param whole the same with every cell kept
  /// \param takes whether a reduction may be used
  /// \pre the arguments outlive this
  /// \throw LimitMet
  SliceSearch(const System& system, const System& whole, const fiacre::Provenance& provenance,
              Takes takes, LimitWatch& limits);

  /// \param open the goals to decide, by index
  /// \param statistics counts the explorations
  /// \return those that were decided
  /// \throw LimitMet
  [[nodiscard]] Bits decide(const std::vector<Goal>& goals, const std::vector<std::size_t>& open,
                            Exploration& statistics, const OnDecided& onDecided);

private:
  struct Group {
    Bits cone;
    std::vector<std::size_t> goals; ///< by index
  };

  [[nodiscard]] std::vector<Group> groupsOf(const std::vector<Goal>& goals,
                                            const std::vector<std::size_t>& open);
  void explore(const Group& group, const std::vector<Goal>& goals, Exploration& statistics,
               const OnDecided& onDecided, Bits& decided);

  const System& whole;
  const fiacre::Provenance& provenance;
  Takes takes;
  LimitWatch& limits;
  Slicer slicer;
};

/// Whether a simple argument shows, without a search, that the goal is never reached.
/// \param whole with every cell kept, and without priorities
/// \throw LimitMet
[[nodiscard]] bool isPlainlyNever(const System& whole, const Goal& goal, LimitWatch& limits);

} // namespace proskill::verify
