#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace proskill::fiacre {

/// Where a part of a model comes from: an index into `Provenance::origins`. 0: from nowhere.
using OriginId = std::uint32_t;

/// What decides that a run passes an origin, so that a reader can be told why it did.
struct Ground {
  enum class Kind : std::uint8_t {
    Condition, ///< `expr` came to `expected`
    Value,     ///< `expr` is what a variable would get
    Move,      ///< `expr` is the value that a variable must not leave in this way
    Cause,     ///< `expr` reads what other processes told: the steps that did so are the reason
  };
  Kind kind = Kind::Condition;
  std::string expr{}; ///< as the printer prints it, over the main component's variables
  /// In the program's words. Condition: the condition, empty where the origin's words have it.
  /// Value: the sum, `energy − 2`. Move: the value to move to.
  std::string text{};
  std::string variable{};  ///< Value: the one that would get it
  bool expected = true;    ///< Condition
  bool afterwards = false; ///< evaluated when the step has been taken
  std::optional<std::pair<std::int64_t, std::int64_t>> bounds{}; ///< Value: those of the variable
  friend bool operator==(const Ground&, const Ground&) = default;
};

/// A place in the program that a model was made from, and what happens there, in that program's
/// words.
struct Origin {
  std::uint32_t file = 0;
  std::uint32_t begin = 0; ///< bytes
  std::uint32_t end = 0;
  std::string actor;       ///< who: a skill, a branch, an event, the environment
  std::string description; ///< what it does: "starts", "succeeds with `at_altitude`"; empty for a
                           ///< bare place
  std::vector<Ground> grounds{};
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
