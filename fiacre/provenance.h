#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace proskill::fiacre {

/// The origin of a part of a model: an index into `Provenance::origins`. 0: none.
using OriginId = std::uint32_t;

/// A reason why a run passes an origin, for explanations.
struct Ground {
  enum class Kind : std::uint8_t {
    Condition, ///< `expr` has the value `expected`
    Value,     ///< `expr` is the value that a variable would get
    Move,      ///< `expr` is the value from which a variable must not move in this way
    Cause,     ///< `expr` depends on other processes: the steps that changed it are the reason
    Need,      ///< the step waits until `expr` is true: reported for deadlocks, not for steps
    Holder,    ///< `text` has what the Need with this `variable` asks for while `expr` is true
  };
  Kind kind = Kind::Condition;
  std::string expr{}; ///< as printed, over the main component's variables
  /// In the program's terms. Condition: the condition; empty if the origin's description contains
  /// it. Value: the sum, `energy − 2`. Move: the value to move to. Need: what is waited for.
  /// Holder: a skill.
  std::string text{};
  std::string variable{};  ///< Value: the variable that would get it. Need, Holder: a resource
  bool expected = true;    ///< Condition
  bool afterwards = false; ///< evaluated after the step
  /// Value: the bounds of the variable.
  std::optional<std::pair<std::int64_t, std::int64_t>> bounds{};

  /// Whether it explains why a step is not possible, rather than why it was taken.
  [[nodiscard]] bool isOfWaits() const { return kind == Kind::Need || kind == Kind::Holder; }
  friend bool operator==(const Ground&, const Ground&) = default;
};

/// A place in the program from which a model was made, and a description of what happens there, in
/// the program's terms.
struct Origin {
  std::uint32_t file = 0;
  std::uint32_t begin = 0; ///< bytes
  std::uint32_t end = 0;
  std::string actor;       ///< a skill, a branch, an event, the environment
  std::string description; ///< "starts", "succeeds with `at_altitude`"; empty if it is only a place
  std::vector<Ground> grounds{};
};

/// A variable of the model that is shown to users.
struct Watched {
  std::string lvalue;  ///< as printed in the model: `battery`, `skill[takeoff].status`
  std::string display; ///< `battery`, `takeoff.status`
  /// The user's names of values that are named differently in the model: `Empty`, not `belt_Empty`.
  std::map<std::string, std::string> values;
};

/// The relation of a model to the program from which it was made.
struct Provenance {
  std::vector<Origin> origins{1};
  std::vector<Watched> watched;
  bool byHand = false; ///< the user wrote the model: all variables and states are shown
};

} // namespace proskill::fiacre
