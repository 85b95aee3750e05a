#pragma once

#include "verify/explore/explorer.h"

namespace proskill::verify {

/// A clock, and between which bounds it is: 0 - x and x - 0.
struct ClockRange {
  ClockId clock = 0;
  Bound lower = kZero;
  Bound upper = kInfinite;
};

/// A reachable moment from which time does not pass unless something happens that need not.
struct StuckMoment {
  NodeIndex node = 0;
  std::vector<ClockRange> clocks; ///< where the clocks stand, of those that matter
  std::vector<Word> state;        ///< the node's, with the values of free inputs for which it is so
};

/// Looks for moments at which time has stopped for ever: time cannot pass, nor after any steps that
/// are due. Due is what time waits for: an urgent step, one whose clock has come to its upper
/// bound, and what has priority over one of these. Other steps need not happen, so they do not
/// help: the environment may be silent, an action may last.
///
/// What can happen in no time depends on a clock only by which bounds it has reached, so the
/// moments of a zone fall into finitely many kinds; of these the graph of due steps is searched. A
/// free input keeps its value meanwhile; its values are told apart when a step depends on it. A
/// moment at which something is due that cannot happen again and again need not be searched: if
/// time has stopped there, it has after that step, too.
///
/// Where no moment is stuck, time diverges: all bounds are whole numbers, so it cannot pass in ever
/// smaller parts only. A step that is possible before a strict bound can be taken before it, and
/// its clock then needs a whole unit to get there again.
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
    std::vector<Word> unknown; ///< bits of free inputs whose value did not matter so far
    TransitionSet enabled;
    SignatureId signature = 0;
    Levels levels;
  };

  /// What time waits for at a moment.
  struct Outlook {
    std::vector<TransitionId> due;     ///< of the steps that may happen again and again
    std::optional<std::uint32_t> open; ///< a free input that decides whether one of them is due
    std::optional<std::uint32_t> openOther; ///< the same of other steps
    bool settled = false; ///< another step is due, or the run ends here by an error

    /// Whether the moment is none of those at which time has stopped and all goes round and round.
    [[nodiscard]] bool isFine() const { return settled || (due.empty() && !open); }
  };

  enum class Verdict : std::uint8_t { Unknown, Good, Bad };

  /// What a search found; where it is not known, the free input that decides.
  struct Found {
    Verdict verdict = Verdict::Unknown;
    std::uint32_t open = 0;
  };

  std::optional<StuckMoment> findAmong(bool urgent);
  void loadNode(StateId state, Moment& moment);
  bool split(const Dbm& zone, std::size_t clock, Moment& moment);
  bool hasStuckChoice(Moment& moment);
  Found search(const Moment& moment);
  [[nodiscard]] Outlook outlook(const Moment& moment);
  [[nodiscard]] bool isAtUpperBound(const Moment& moment, TransitionId transition);
  [[nodiscard]] bool isAwaited(const Moment& moment, TransitionId transition);
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
  TransitionSet recurrent;
  std::string stoppedBy;
  std::uint64_t steps = 0;          ///< since the start, to look at the limits now and then
  std::size_t levelsFrom;           ///< the word of a stored moment where its levels begin
  StateStore moments;               ///< states, unknown bits where there are free inputs, levels
  std::vector<Verdict> verdicts;    ///< by moment
  std::vector<std::uint32_t> metIn; ///< by moment: the last search that met it
  std::uint32_t searches = 0;
  std::vector<std::vector<Thresholds>> known; ///< by signature
  std::vector<Word> key;
  StepLog log;
};

} // namespace proskill::verify
