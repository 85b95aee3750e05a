#pragma once

#include "fiacre/syntax/tree.h"
#include "verify/verify.h"

#include <expected>
#include <memory>

namespace proskill::verify {

/// A step that may be taken next.
struct Choice {
  Step step; ///< as in a trace: `date` is when it would be taken, `changes` what it would change
  std::int64_t scale = 1; ///< of all dates here: they are in units of 1/scale of the model's unit
  std::int64_t earliest = 0;          ///< given the steps taken so far at their dates
  bool afterEarliest = false;         ///< the date itself is excluded
  std::optional<std::int64_t> latest; ///< nullopt: unbounded
  bool beforeLatest = false;
  /// Whether the step must be taken eventually, unless another step prevents it.
  bool bounded = false;
};

/// Which of its possible dates a step is taken at.
enum class When : std::uint8_t {
  Early,
  Late, ///< if the latest date is excluded, just before it; if there is none, as `Early`
};

/// A run of a model whose steps the caller chooses. Values and dates are concrete.
/// \pre the model outlives this
class Simulation {
public:
  [[nodiscard]] static std::expected<Simulation, Unsupported>
  start(const fiacre::Program& program, const fiacre::Provenance& provenance);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// The initial value of each watched variable, in `after`.
  [[nodiscard]] const std::vector<Change>& initial() const;
  /// The possible next steps, the likeliest first: steps that must happen, ordered by their latest
  /// date, then steps that may never happen. Empty if no step is possible.
  [[nodiscard]] std::vector<Choice> choices() const;
  /// Takes a step and returns its date in units of `Choice::scale`. \pre choice < choices().size()
  std::int64_t take(std::size_t choice, When when = When::Early);
  /// Undoes the last step; returns false at the start.
  bool undo();

private:
  struct State;
  explicit Simulation(std::unique_ptr<State> made);
  std::unique_ptr<State> state;
};

} // namespace proskill::verify
