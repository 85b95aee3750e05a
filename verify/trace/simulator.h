#pragma once

#include "verify/state/run.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

/// Executes a system on concrete values and dates. It uses the transitions, but no zones, clocks or
/// reductions: every transition has an age of its own.
namespace proskill::verify {

/// Since when transitions have been enabled, in units of 1/scale; ordered by transition. States are
/// copied and compared at each step, so this is one block of memory.
class EnabledSince {
public:
  using Entry = std::pair<TransitionId, std::int64_t>;
  using Iterator = std::vector<Entry>::const_iterator;

  /// \pre later than all others in the order
  void add(TransitionId id, std::int64_t date) { entries.emplace_back(id, date); }
  void reserve(std::size_t count) { entries.reserve(count); }
  [[nodiscard]] Iterator begin() const { return entries.begin(); }
  [[nodiscard]] Iterator end() const { return entries.end(); }
  [[nodiscard]] bool empty() const { return entries.empty(); }
  [[nodiscard]] std::size_t size() const { return entries.size(); }
  [[nodiscard]] Iterator find(TransitionId id) const {
    const auto found = std::ranges::lower_bound(entries, id, {}, &Entry::first);
    return found != end() && found->first == id ? found : end();
  }
  [[nodiscard]] bool contains(TransitionId id) const { return find(id) != end(); }
  /// \pre contains(id)
  [[nodiscard]] std::int64_t at(TransitionId id) const { return find(id)->second; }
  friend auto operator<=>(const EnabledSince&, const EnabledSince&) = default;

private:
  std::vector<Entry> entries;
};

/// A discrete state, and since when each of its enabled transitions has been enabled.
struct Concrete {
  std::vector<Word> state;
  EnabledSince since;
  friend auto operator<=>(const Concrete&, const Concrete&) = default;
};

/// When a step may happen, in units of 1/scale since the start.
struct Opportunity {
  std::int64_t earliest = 0;
  bool afterEarliest = false;         ///< `earliest` itself is excluded
  std::optional<std::int64_t> latest; ///< nullopt: unbounded
  bool beforeLatest = false;          ///< `latest` itself is excluded
};

class Simulator {
public:
  /// \param units number of time units in one unit of the model
  Simulator(const System& of, std::int64_t units);

  /// Changes the unit of dates.
  void setUnits(std::int64_t units) { scale = units; }

  [[nodiscard]] Concrete start() const;
  /// Whether no step has to happen before `date`.
  [[nodiscard]] bool mayWait(const Concrete& now, std::int64_t date) const;
  /// Whether no step ever has to happen.
  [[nodiscard]] bool mayRest(const Concrete& now) const;
  [[nodiscard]] bool isRipe(const Concrete& now, TransitionId id, std::int64_t date) const;
  /// When an enabled transition may be taken, from `date` on; nothing if other steps have to happen
  /// before. \pre the transition is enabled
  [[nodiscard]] std::optional<Opportunity> opportunity(const Concrete& now, TransitionId id,
                                                       std::int64_t date) const;
  /// Whether the step causes an error of the model; `log` then has the fault.
  [[nodiscard]] bool fails(const Concrete& now, TransitionId id, StepLog& log) const;
  /// Takes a step; `log` receives what happens in it. Nothing if the step fails.
  [[nodiscard]] std::optional<Concrete> take(const Concrete& now, TransitionId id,
                                             std::int64_t date, StepLog& log) const;
  /// Whether time can pass now, or after steps that must happen now. Returns false if there are too
  /// many such steps to examine them all, because the reductions of a search cannot be used here.
  [[nodiscard]] bool canGoOn(const Concrete& now, std::int64_t date) const;

private:
  /// Adds transitions that take part in an instance's present location.
  void addTakingPart(InstanceId instance, const std::vector<Word>& state,
                     std::vector<TransitionId>& to) const;
  /// Those that a step between two states may enable, disable or disturb, in their order.
  [[nodiscard]] std::vector<TransitionId> affected(TransitionId step,
                                                   const std::vector<Word>& before,
                                                   const std::vector<Word>& after) const;
  [[nodiscard]] bool isOldEnough(const Concrete& now, TransitionId id, std::int64_t date) const;
  [[nodiscard]] bool isBlocked(const Concrete& now, TransitionId id) const;
  [[nodiscard]] TransitionId withoutObservers(TransitionId id) const;
  [[nodiscard]] bool isAwaited(const Concrete& now, TransitionId id, std::int64_t date) const;
  [[nodiscard]] bool mayWaitALittle(const Concrete& now, std::int64_t date) const;

  const System& system;
  std::int64_t scale;
  /// By instance and location: transitions of which a part is there.
  std::vector<std::vector<std::vector<TransitionId>>> takingPart;
  /// By cell: transitions whose guards read it, unless it is the location of a part.
  std::vector<std::vector<TransitionId>> readers;
};

} // namespace proskill::verify
