#pragma once

#include "fiacre/syntax/tree.h"
#include "verify/verify.h"

#include <expected>
#include <memory>

namespace proskill::verify {

/// A step that may come next.
struct Choice {
  Step step; ///< as a trace has it: `date` is when it would be taken, the changes those it makes
  std::int64_t scale = 1;             ///< of all dates here: units of 1/scale of the model's unit
  std::int64_t earliest = 0;          ///< after the steps that were taken, at their dates
  bool afterEarliest = false;         ///< not at that date itself
  std::optional<std::int64_t> latest; ///< nothing: as late as one likes
  bool beforeLatest = false;
  /// Whether it has to be taken at last, unless something else prevents it.
  bool bounded = false;
};

/// When a step is taken, of all the dates at which it can be.
enum class When : std::uint8_t {
  Early,
  Late, ///< just before, where the last date is not reached itself; as `Early` where there is none
};

/// A run of a model that somebody else chooses the steps of. Values and dates are concrete.
/// \pre the model outlives this
class Simulation {
public:
  [[nodiscard]] static std::expected<Simulation, Unsupported>
  start(const fiacre::Program& program, const fiacre::Provenance& provenance);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// Every watched variable's first value, in `after`.
  [[nodiscard]] const std::vector<Change>& initial() const;
  /// What may come next, the likeliest first: what has to happen soonest, before what may never
  /// happen. Empty where nothing is possible any more.
  [[nodiscard]] std::vector<Choice> choices() const;
  /// Takes one of them; returns its date, in units of `Choice::scale`. \pre choice <
  /// choices().size()
  std::int64_t take(std::size_t choice, When when = When::Early);
  /// Takes the last step back; false at the start.
  bool undo();

private:
  struct State;
  explicit Simulation(std::unique_ptr<State> made);
  std::unique_ptr<State> state;
};

} // namespace proskill::verify
