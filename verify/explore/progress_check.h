#pragma once

#include "verify/explore/explorer.h"

namespace proskill::verify {

/// A clock, and between which bounds it is: 0 - x and x - 0.
struct ClockRange {
  ClockId clock = 0;
  Bound lower = kZero;
  Bound upper = kInfinite;
};

/// A reachable moment from which no run lets time pass.
struct StuckMoment {
  NodeIndex node = 0;
  std::vector<ClockRange> clocks; ///< where the clocks stand, of those that matter
};

/// Looks for moments at which time has stopped for ever: time cannot pass, nor after any steps that
/// take no time. What can happen in no time depends on a clock only by which bounds it has reached,
/// so the moments of a zone fall into finitely many kinds; of these the graph of steps without time
/// is searched.
class ProgressCheck {
public:
  /// \pre the arguments outlive this
  ProgressCheck(const System& system, const Reductions& reductions, ZoneGraph& graph,
                LimitWatch& limits);

  /// Nothing where there is none, or where a limit stopped the search.
  [[nodiscard]] std::optional<StuckMoment> find();
  /// Which limit was met, empty where none was.
  [[nodiscard]] const std::string& stopped() const { return stoppedBy; }

private:
  /// How many of its thresholds a clock has reached; by clock, in the order of the signature.
  using Levels = std::vector<std::uint8_t>;

  /// What a clock may reach, from the first on: the lower bounds of its transitions, then its upper
  /// bound.
  struct Thresholds {
    std::vector<Bound> lower; ///< as limits of 0 - x
    bool endsAtUpper = false; ///< the last one is the upper bound: there time stops
  };

  struct Moment {
    std::vector<Word> state;
    TransitionSet enabled;
    SignatureId signature = 0;
    Levels levels;
  };

  enum class Verdict : std::uint8_t { Unknown, Good, Bad };

  std::optional<StuckMoment> findAmong(bool urgent);
  bool split(const Dbm& zone, std::size_t clock, Moment& moment);
  bool isGood(const Moment& moment);
  [[nodiscard]] bool letsTimePass(const Moment& moment);
  [[nodiscard]] bool canFire(const Moment& moment, TransitionId transition);
  [[nodiscard]] bool isBlocked(const Moment& moment, TransitionId transition);
  [[nodiscard]] bool fireFrom(const Moment& moment, TransitionId transition, Moment& next);
  StateId number(Moment& moment);
  void load(StateId id, Moment& moment);
  [[nodiscard]] const std::vector<Thresholds>& thresholds(SignatureId signature);
  [[nodiscard]] std::vector<ClockRange> ranges(const Moment& moment);

  bool isStopped();

  const System& system;
  const Reductions& reductions;
  ZoneGraph& graph;
  LimitWatch& limits;
  std::string stoppedBy;
  std::uint64_t steps = 0;          ///< since the start, to look at the limits now and then
  StateStore moments;               ///< states with levels behind them
  std::vector<Verdict> verdicts;    ///< by moment
  std::vector<std::uint32_t> metIn; ///< by moment: the last search that met it
  std::uint32_t searches = 0;
  std::vector<std::vector<Thresholds>> known; ///< by signature
  std::vector<Word> key;
  StepLog log;
};

} // namespace proskill::verify
