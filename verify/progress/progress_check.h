#pragma once

#include "verify/limits.h"
#include "verify/progress/explored_nodes.h"
#include "verify/reduce/reductions.h"

namespace proskill::verify {

/// Bounds on a clock x: `lower` limits 0 - x, `upper` limits x - 0.
struct ClockRange {
  ClockId clock = 0;
  Bound lower = kZero;
  Bound upper = kInfinite;
};

/// A reachable moment at which time is stopped unless an optional step happens.
struct StuckMoment {
  std::uint64_t node = 0;         ///< its number among the explored ones
  std::vector<ClockRange> clocks; ///< bounds on the relevant clocks
  std::vector<Word> state; ///< of the node, with values of free inputs for which time is stopped
};

/// Searches for moments at which time has stopped for ever: time cannot pass now, nor after any due
/// steps. A step is due if time waits for it: it is urgent, its clock has reached its upper bound,
/// or it has priority over such a step. Other steps are optional, so they do not help: the
/// environment may do nothing, and an action may last.
///
/// The steps that are possible without time passing depend only on which bounds each clock has
/// reached. So the moments of a zone fall into finitely many classes, and the graph of due steps
/// over these is searched. A free input keeps its value during this search; values are
/// distinguished when a step depends on them. A moment with a due step that cannot happen
/// infinitely often need not be searched: if time has stopped there, it has also stopped after this
/// step.
///
/// If no moment is stuck, time diverges: all bounds are integers, so time cannot pass in ever
/// smaller amounts only. A step that is possible before a strict bound can be taken before it, and
/// its clock then needs a whole unit to reach the bound again.
class ProgressCheck {
public:
  /// \pre the arguments outlive this
  /// \param bytes that may be used to remember moments; more are forgotten
  ProgressCheck(const System& system, const Reductions& reductions, ExploredNodes& nodes,
                LimitWatch& limits, std::uint64_t bytes = UINT64_MAX);

  /// A stuck moment; nothing if there is none or if a limit stopped the search.
  [[nodiscard]] std::optional<StuckMoment> find();
  /// The limit that was met; empty if none was.
  [[nodiscard]] const std::string& stopped() const { return stoppedBy; }

private:
  /// Number of thresholds that each clock has reached, in the order of the signature.
  using Levels = std::vector<std::uint8_t>;

  /// The thresholds of a clock, ascending: the lower bounds of its transitions, then its upper
  /// bound.
  struct Thresholds {
    std::vector<Bound> lower; ///< as bounds on 0 - x
    bool endsAtUpper = false; ///< the last threshold is the upper bound, at which time stops
  };

  struct Moment {
    std::vector<Word> state;
    std::vector<Word> unknown; ///< bits of free inputs whose value has not mattered so far
    TransitionSet enabled;
    SignatureId signature = 0;
    Levels levels;
  };

  /// The due steps of a moment.
  struct Outlook {
    std::vector<TransitionId> due; ///< due steps that may happen infinitely often
    /// A free input on which it depends whether one of them is due.
    std::optional<std::uint32_t> open;
    /// The same for steps that cannot happen infinitely often.
    std::optional<std::uint32_t> openOther;
    bool settled = false; ///< another step is due, or the run ends here with an error

    /// Whether time is not stopped at this moment by steps that may repeat for ever.
    [[nodiscard]] bool isFine() const { return settled || (due.empty() && !open); }
  };

  /// Open: no due steps lead to a good moment before a free input is chosen.
  enum class Verdict : std::uint8_t { Unknown, Good, Bad, Open };

  /// The result of a search; if it is Open, a free input on which it may depend.
  struct Found {
    Verdict verdict = Verdict::Unknown;
    std::uint32_t open = 0;
  };

  std::optional<StuckMoment> findAmong(bool urgent);
  void loadNode(Moment& moment);
  bool split(const Dbm& zone, std::size_t clock, Moment& moment);
  bool hasStuckChoice(Moment& moment);
  Found search(const Moment& moment);
  [[nodiscard]] Outlook outlook(const Moment& moment);
  [[nodiscard]] bool isAtUpperBound(const Moment& moment, TransitionId transition);
  [[nodiscard]] bool isAwaited(const Moment& moment, TransitionId transition);
  [[nodiscard]] bool canFire(const Moment& moment, TransitionId transition);
  [[nodiscard]] bool isBlocked(const Moment& moment, TransitionId transition);
  [[nodiscard]] bool fireFrom(const Moment& moment, TransitionId transition, Moment& next);
  StateId number(const Moment& moment);
  StateId numberAfterStep(Moment& moment);
  void makeKey(const Moment& moment);
  void load(StateId id, Moment& moment);
  [[nodiscard]] const std::vector<Thresholds>& thresholds(SignatureId signature);
  [[nodiscard]] std::vector<ClockRange> ranges(const Moment& moment);

  bool isStopped();
  [[nodiscard]] std::uint64_t rememberedBytes() const;
  void forget();

  const System& system;
  const Reductions& reductions;
  ExploredNodes& graph;
  LimitWatch& limits;
  std::uint64_t mostBytes;
  TransitionSet recurrent;
  std::string stoppedBy;
  std::uint64_t steps = 0;       ///< since the start; the limits are checked every so many steps
  std::size_t levelsFrom;        ///< index of the word of a stored moment at which its levels begin
  StateStore moments;            ///< states, unknown bits where there are free inputs, levels
  LargeVector<Verdict> verdicts; ///< by moment
  LargeVector<std::uint32_t> metIn;  ///< by moment: the last search that reached it
  LargeVector<std::uint32_t> openAt; ///< by moment: if it is open, a free input to choose
  std::uint32_t searches = 0;
  std::vector<std::vector<Thresholds>> known; ///< by signature
  std::vector<Word> key;
  StepLog log;
};

} // namespace proskill::verify
