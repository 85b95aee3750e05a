#pragma once

#include "runtime/monitor/date_zone.h"
#include "verify/model/monitor.h"
#include "verify/state/evaluate.h"

namespace proskill::runtime {

/// Follows a monitor of verify/model/monitor.h along a run. It keeps every location in which the
/// monitor can be, with every value that its clock can have there.
class PatternMonitor {
public:
  /// \param unit of the monitor's clock \pre the system and the monitor outlive this
  PatternMonitor(const verify::System& system, const verify::Monitor& monitor, Nanoseconds unit);

  /// The run is in its initial state at date 0.
  void start(const verify::Word* state);
  /// Time passes in a state.
  void wait(const verify::Word* state, Nanoseconds until);
  /// The run takes a step at the date until which it waited. \param moment with the state after it
  void step(const verify::Moment& moment);

  /// When the property was violated, whatever follows.
  [[nodiscard]] std::optional<Nanoseconds> violated() const { return firstError; }
  /// Whether the property can no longer be violated.
  [[nodiscard]] bool cannotBeViolated() const { return !firstError && !isLost && isEmpty; }
  /// The next date at which one of the two becomes true if the run stays in this state.
  [[nodiscard]] std::optional<Nanoseconds> nextDecision(const verify::Word* state) const;
  [[nodiscard]] Nanoseconds date() const { return now; }

private:
  struct Found {
    std::uint32_t location = 0;
    DateZone zone;
  };
  /// What the monitor can do while the run stays in a state.
  struct Stay {
    std::vector<Found> all;
    std::optional<Nanoseconds> error;
    bool isTooLarge = false;
  };

  void findLimits();
  [[nodiscard]] std::int64_t limitBy(std::uint32_t from, const verify::MonitorEdge& edge) const;
  [[nodiscard]] bool restsIn(const verify::Word* state) const;
  [[nodiscard]] Stay stayIn(const verify::Word* state, std::optional<Nanoseconds> until) const;
  static void addTo(Stay& stay, Found found);
  [[nodiscard]] std::optional<Found> moved(const Found& from,
                                           const verify::MonitorEdge& edge) const;
  [[nodiscard]] DateBound inDates(verify::Bound bound) const;
  void add(std::vector<std::vector<DateRange>>& to, std::uint32_t location, DateRange range);
  void forgetOld();

  const verify::System& system;
  const verify::Monitor& monitor;
  const Nanoseconds unit;
  Nanoseconds most = -1; ///< the largest value with which the clock is compared; -1: none
  /// By location: the last position of the clock from which a violation can follow; negative: none.
  std::vector<std::int64_t> limits;
  std::vector<std::vector<DateRange>> resets; ///< by location; none: the monitor is not there
  std::vector<std::vector<DateRange>> next;
  Nanoseconds now = 0;
  std::optional<Nanoseconds> firstError;
  bool isEmpty = false;
  bool isLost = false; ///< there are too many values of the clock to follow
};

} // namespace proskill::runtime
