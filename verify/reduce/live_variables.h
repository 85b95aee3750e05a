#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/state/store.h"

#include <map>

namespace proskill::verify {

/// Sets every variable that will be written before it is read to one value, so that states that
/// differ only in such variables become one. Bozga, Fernandez, Ghirvu, "State space reduction based
/// on live variables analysis", SAS 1999. A process that waits for a cell that nobody will write
/// any more reads nothing from then on.
class LiveVariables {
public:
  /// \pre the system has a state layout \throw LimitMet
  LiveVariables(const System& system, const std::vector<Goal>& goals, const Bits& dropped,
                LimitWatch& limits);
  /// The same for another thread, with caches of its own. \pre `from` outlives it
  LiveVariables(const LiveVariables& from, LimitWatch& watch) : LiveVariables(from) {
    limits = &watch;
  }

  /// Sets the dead cells of a packed state to their lowest value. A second call changes nothing.
  void clean(Word* state) const;
  /// Bytes of what is remembered about states, and a way to forget it.
  [[nodiscard]] std::uint64_t rememberedBytes() const;
  void forget() const;

private:
  /// A condition on one cell that must hold before a path can be taken.
  struct Need {
    NodeId condition = 0;
    /// Cells that anyone who makes it true surely writes, except cells of conditions.
    Bits rewritten;
    std::vector<Word> rewrittenMask; ///< the same as a mask of packed states
  };

  /// A path out of a location that an instance may take.
  struct Way {
    PathId path = 0;
    std::vector<Need> needs;
    Bits live; ///< cells that it may read before writing them, on this path or later
    std::vector<Word> liveMask; ///< the same as a mask of packed states
  };

  /// What an instance in a location may do with cells.
  struct Place {
    std::vector<Way> ways;
    Bits later;                 ///< cells that it may write, now or later
    std::vector<NodeId> needed; ///< conditions that all paths require, each on one cell
    std::vector<CellId> read;   ///< by condition: its cell
    // the same as masks of packed states:
    std::vector<Word> surelyLive; ///< live whatever the conditions, if the instance may move
    std::vector<Word> writes;
    std::vector<std::vector<Word>> neededCells;
  };

  using PathsOf = std::vector<std::vector<PathId>>; ///< by instance

  void findNeeded(const PathsOf& paths, InstanceId instance);
  void findWays(const PathsOf& paths, InstanceId instance);
  [[nodiscard]] Bits rewrittenFor(InstanceId instance, NodeId condition) const;
  void findLive(std::vector<Place>& all);
  [[nodiscard]] std::uint64_t maskBytes() const;
  void findMasks(Place& place) const;
  [[nodiscard]] std::vector<Word> maskOf(const Bits& cells) const;
  [[nodiscard]] bool isAllLive(const Word* state) const;
  [[nodiscard]] bool mayAllMove() const;
  bool follow(const std::vector<Place>& all, Place& from, Way& way);
  [[nodiscard]] std::vector<Word> liveMask(const Word* state) const;
  void addLive(const Place& place, const Word* state, std::vector<Word>& mask) const;
  void findHere(const Word* state) const;
  void findFrozen(const Word* state) const;
  bool dropUnmet(InstanceId instance, const Bits& written) const;

  const System& system;
  LimitWatch* limits;
  Bits allCells;
  std::vector<std::vector<PathId>> writing; ///< by cell: paths that may be taken and write it
  std::vector<std::vector<Place>> places;   ///< by instance and location
  std::vector<std::map<std::uint32_t, Bits>> written; ///< by path: surelyWritten
  Bits always;                                        ///< cells that goals read, and locations
  std::vector<Word>
      keyMask; ///< The part of a state that determines the dead cells: locations and needed cells.
  std::vector<Word> allMask;    ///< of all cells
  std::vector<Word> alwaysMask; ///< of `always`
  // of the state that is cleaned:
  mutable std::vector<const Place*> here; ///< by instance
  mutable std::vector<Word> live;
  mutable std::vector<Word> writes;
  /// An instance that cannot move now, and how many of the first cells in `waitsFor` are not its
  /// own.
  struct Waiting {
    const Place* place = nullptr;
    std::size_t first = 0;
  };
  mutable std::vector<Waiting> waiting;
  mutable std::vector<const std::vector<Word>*> waitsFor; ///< cells of conditions that are false
  mutable std::vector<std::vector<CellId>> unmet; ///< by instance: cells that keep it from moving
  mutable std::vector<Word> own;                  ///< live cells of one path
  mutable StateStore keys;
  mutable std::vector<std::vector<Word>> masks; ///< by key
  mutable std::vector<Word> key;
  mutable std::vector<Word> lastKey; ///< successors of one state often have the same key
  mutable StateId last = 0;
};

} // namespace proskill::verify
