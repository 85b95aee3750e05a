#pragma once

#include "verify/goals.h"
#include "verify/store.h"

#include <map>

namespace proskill::verify {

/// Gives one value to every variable that will be written before it is read again, so that states
/// that differ only in such variables are one. Bozga, Fernandez, Ghirvu, "State space reduction
/// based on live variables analysis", SAS 1999. A process that waits for a cell that nobody will
/// ever write again reads nothing any more.
class LiveVariables {
public:
  /// \pre the system is placed
  LiveVariables(const System& system, const std::vector<Goal>& goals, const Bits& dropped);

  /// Sets the dead cells of a packed state to their least value.
  void clean(Word* state) const;

private:
  /// What an instance in a location has to do with cells.
  struct Place {
    Bits live;                  ///< it may read them before it writes them
    Bits later;                 ///< it may write them, now or later
    std::vector<NodeId> needed; ///< conditions on one cell each; no path goes on where one is false
    /// By needed condition: what whoever makes it true surely writes, apart from cells of
    /// conditions.
    std::vector<Bits> rewritten;
  };

  using PathsOf = std::vector<std::vector<PathId>>; ///< by instance

  void findNeeded(const PathsOf& paths, InstanceId instance);
  void findRewritten(const PathsOf& paths, InstanceId instance, Place& place);
  void findLive(const std::vector<PathId>& own, std::vector<Place>& all);
  [[nodiscard]] std::vector<Word> maskOf(const Word* state) const;
  [[nodiscard]] std::vector<Bits> frozenNeeds(const Word* state) const;

  const System& system;
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
