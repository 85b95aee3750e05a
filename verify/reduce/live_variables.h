#pragma once

#include "verify/limits.h"
#include "verify/model/goals.h"
#include "verify/state/store.h"

#include <map>

namespace proskill::verify {

/// Gives one value to every variable that will be written before it is read again, so that states
/// that differ only in such variables are one. Bozga, Fernandez, Ghirvu, "State space reduction
/// based on live variables analysis", SAS 1999. A process that waits for a cell that nobody will
/// ever write again reads nothing any more.
class LiveVariables {
public:
  /// \pre the system has a state layout \throw LimitMet
  LiveVariables(const System& system, const std::vector<Goal>& goals, const Bits& dropped,
                LimitWatch& limits);

  /// Sets the dead cells of a packed state to their least value.
  void clean(Word* state) const;

private:
  /// A condition on one cell, without which a path cannot be taken.
  struct Need {
    NodeId condition = 0;
    Bits rewritten; ///< what whoever makes it true surely writes, apart from cells of conditions
  };

  /// What an instance may do by one path out of a location.
  struct Way {
    PathId path = 0;
    std::vector<Need> needs;
    Bits live; ///< cells that it may read before it writes them, on this path or behind it
  };

  /// What an instance in a location has to do with cells.
  struct Place {
    std::vector<Way> ways;
    Bits later;                 ///< it may write them, now or later
    std::vector<NodeId> needed; ///< conditions that all paths need
  };

  using PathsOf = std::vector<std::vector<PathId>>; ///< by instance

  void findNeeded(const PathsOf& paths, InstanceId instance);
  void findWays(const PathsOf& paths, InstanceId instance);
  [[nodiscard]] Bits rewrittenFor(InstanceId instance, NodeId condition) const;
  void findLive(std::vector<Place>& all);
  bool follow(const std::vector<Place>& all, Place& from, Way& way);
  [[nodiscard]] std::vector<Word> maskOf(const Word* state) const;
  [[nodiscard]] std::vector<Bits> frozenNeeds(const Word* state) const;

  const System& system;
  LimitWatch& limits;
  Bits allCells;
  std::vector<std::vector<PathId>> writing;           ///< by cell: paths that may be taken
  std::vector<std::vector<Place>> places;             ///< by instance and location
  std::vector<std::map<std::uint32_t, Bits>> written; ///< by path: surelyWritten
  Bits always;                                        ///< cells that goals look at, and locations
  std::vector<Word>
      keyMask; ///< the part of a state that tells which cells are dead: locations and needed cells
  mutable StateStore keys;
  mutable std::vector<std::vector<Word>> masks; ///< by key
  mutable std::vector<Word> key;
  mutable std::vector<Word> lastKey; ///< successors of one state often share it
  mutable StateId last = 0;
};

} // namespace proskill::verify
