#pragma once

#include "verify/state/run.h"

#include <map>
#include <optional>
#include <vector>

/// Runs of a system on concrete values and dates. It knows the transitions, but neither zones nor
/// clocks nor reductions: every transition has its own age.
namespace proskill::verify {

/// A discrete state, and since when each enabled transition is enabled.
struct Concrete {
  std::vector<Word> state;
  std::map<TransitionId, std::int64_t> since; ///< in units of 1/scale
  friend auto operator<=>(const Concrete&, const Concrete&) = default;
};

/// When something may happen, in units of 1/scale since the start.
struct Opportunity {
  std::int64_t earliest = 0;
  bool afterEarliest = false;         ///< not at `earliest` itself
  std::optional<std::int64_t> latest; ///< nothing: as late as one likes
  bool beforeLatest = false;          ///< not at `latest` itself
};

class Simulator {
public:
  /// \param units of time in one unit of the model
  Simulator(const System& of, std::int64_t units);

  [[nodiscard]] Concrete start() const;
  /// Whether nothing has to happen before `date`.
  [[nodiscard]] bool mayWait(const Concrete& now, std::int64_t date) const;
  /// Whether nothing ever has to happen.
  [[nodiscard]] bool mayRest(const Concrete& now) const;
  [[nodiscard]] bool isRipe(const Concrete& now, TransitionId id, std::int64_t date) const;
  /// When an enabled transition may be taken, from `date` on; nothing where others have to happen
  /// before. \pre it is enabled
  [[nodiscard]] std::optional<Opportunity> opportunity(const Concrete& now, TransitionId id,
                                                       std::int64_t date) const;
  /// Whether the step is an error of the model; what went wrong is in `log`.
  [[nodiscard]] bool fails(const Concrete& now, TransitionId id, StepLog& log) const;
  /// The step itself; what it passes is in `log`. Nothing where it fails.
  [[nodiscard]] std::optional<Concrete> take(const Concrete& now, TransitionId id,
                                             std::int64_t date, StepLog& log) const;
  /// Whether time is seen to pass now, or after steps that have to happen now. Gives up, with
  /// false, where these are too many to look at each: it cannot use the reductions of a search.
  [[nodiscard]] bool canGoOn(const Concrete& now, std::int64_t date) const;

private:
  [[nodiscard]] std::vector<TransitionId> enabledIn(const std::vector<Word>& state) const;
  [[nodiscard]] bool isOldEnough(const Concrete& now, TransitionId id, std::int64_t date) const;
  [[nodiscard]] bool isBlocked(const Concrete& now, TransitionId id) const;
  [[nodiscard]] TransitionId withoutObservers(TransitionId id) const;
  [[nodiscard]] bool isAwaited(const Concrete& now, TransitionId id, std::int64_t date) const;
  [[nodiscard]] bool mayWaitALittle(const Concrete& now, std::int64_t date) const;

  const System& system;
  std::int64_t scale;
  /// By instance and location: transitions whose first part is there.
  std::vector<std::vector<std::vector<TransitionId>>> startingAt;
};

} // namespace proskill::verify
