#pragma once

#include "verify/answer_store.h"
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
  /// \param store keeps what never happens in slices; may be null
  SliceSearch(const System& system, const System& whole, const fiacre::Provenance& provenance,
              Takes takes, LimitWatch& limits, AnswerStore* store = nullptr);

  /// \param open the goals to decide, by index
  /// \param most size of all explorations together, the smallest parts first
  /// \param statistics counts the explorations
  /// \return those that were decided
  /// \throw LimitMet
  [[nodiscard]] Bits decide(const std::vector<Goal>& goals, const std::vector<std::size_t>& open,
                            const SearchSize& most, Exploration& statistics,
                            const OnDecided& onDecided);
  /// Whether a larger size might have decided more.
  [[nodiscard]] bool wasCutShort() const { return isCutShort; }

private:
  struct Group {
    std::vector<std::size_t> goals; ///< by index; the slice is made for them
    std::vector<std::size_t> open;  ///< those of them that are to be decided
  };

  [[nodiscard]] std::vector<Group> groupsOf(const std::vector<Goal>& goals,
                                            const std::vector<std::size_t>& open);
  [[nodiscard]] std::vector<std::size_t> grouped(const std::vector<Goal>& goals,
                                                 const std::vector<std::size_t>& open) const;
  [[nodiscard]] std::vector<std::size_t> withoutKnown(const Group& group, const Slice& slice,
                                                      const std::vector<Goal>& goals,
                                                      const OnDecided& onDecided, Bits& decided);
  void explore(const Group& group, const std::vector<Goal>& goals, Exploration& statistics,
               const OnDecided& onDecided, Bits& decided);
  void count(const SearchResult& found, Exploration& statistics);
  [[nodiscard]] bool isNever(const Slice& slice, const Goal& goal, Exploration& statistics);
  [[nodiscard]] bool neverDeadlocks(Exploration& statistics);
  [[nodiscard]] bool neverStopsTime(Exploration& statistics);

  const System& whole;
  const fiacre::Provenance& provenance;
  Takes takes;
  LimitWatch& limits;
  AnswerStore* store;
  Slicer slicer;
  SearchSize left; ///< of all explorations that follow
  bool isCutShort = false;
};

/// How many instances a part has at most that is worth exploring on its own: not almost all of
/// those of the system.
[[nodiscard]] std::size_t mostInSmallPart(const Bits& all);
/// Whether a part is as small as that.
[[nodiscard]] bool isSmallPart(const Bits& cone, const Bits& all);

/// Whether a simple argument shows, without a search, that the goal is never reached.
/// \param whole with every cell kept, and without priorities
/// \throw LimitMet
[[nodiscard]] bool isPlainlyNever(const System& whole, const Goal& goal, LimitWatch& limits);

} // namespace proskill::verify
