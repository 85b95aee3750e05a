#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace proskill::fiacre {

/// Where a part of a model comes from: an index into `Provenance::origins`. 0: from nowhere.
using OriginId = std::uint32_t;

/// A place in the program that a model was made from, and what happens there, in that program's
/// words.
struct Origin {
  std::uint32_t file = 0;
  std::uint32_t begin = 0; ///< bytes
  std::uint32_t end = 0;
  std::string actor;       ///< who: a skill, a branch, an event, the environment
  std::string description; ///< what it does: "starts", "succeeds with `at_altitude`"; empty for a
                           ///< bare place
};

/// A variable of the model that a user knows, and how to show it.
struct Watched {
  std::string lvalue;  ///< as the printer prints it: `battery`, `skill[takeoff].status`
  std::string display; ///< `battery`, `takeoff.status`
  /// What a user calls values that the model calls something else: `Empty`, not `belt_Empty`.
  std::map<std::string, std::string> values;
};

/// What a model tells about the program that it was made from.
struct Provenance {
  std::vector<Origin> origins{1};
  std::vector<Watched> watched;
  bool byHand = false; ///< the model is what the user wrote: all variables and states are shown
};

} // namespace proskill::fiacre
