#pragma once

#include "runtime/machine/monitored.h"
#include "runtime/monitor/formula_monitor.h"
#include "runtime/monitor/pattern_monitor.h"

#include <functional>
#include <list>
#include <optional>
#include <variant>
#include <vector>

namespace proskill::runtime {

/// Decides a program's own properties along a run. A verdict is final: it holds for the run however
/// it goes on. What a finite run cannot decide stays `NotYet`.
class PropertyMonitors {
public:
  /// A step of a run.
  struct Taken {
    const verify::Word* before = nullptr;
    const verify::Word* after = nullptr;
    const std::vector<verify::EventId>& events;
    Nanoseconds date = 0;
    /// It only asks an action to stop. In the model the action ends in this very step.
    bool asksToStop = false;
  };
  struct Decision {
    std::size_t property = 0;
    Verdict verdict = Verdict::NotYet;
    Nanoseconds date = 0;
  };

  /// \param unit of the model's time \pre the system and the properties outlive this
  PropertyMonitors(const verify::System& system, const std::vector<Monitored>& properties,
                   Nanoseconds unit);

  /// Receives what is decided.
  using Decided = std::function<void(const Decision&)>;

  void start(const verify::Word* state, const Decided& decided);
  void step(const Taken& step, const Decided& decided);
  /// The run stays in a state until this date.
  void wait(const verify::Word* state, Nanoseconds until, const Decided& decided);

  /// The next date at which something is decided if the run stays in this state.
  [[nodiscard]] std::optional<Nanoseconds> nextDecision(const verify::Word* state);
  /// By property.
  [[nodiscard]] const std::vector<Decision>& verdicts() const { return decisions; }

private:
  /// A condition or event that must not occur, or has to occur once.
  struct Reach {
    const verify::Goal* goal;
    std::optional<Nanoseconds> found;
  };
  /// The automaton of a formula, and that of its negation.
  struct Formula {
    FormulaMonitor itself;
    FormulaMonitor negation;
  };
  struct Watch {
    std::size_t property = 0;
    std::variant<Reach, PatternMonitor, Formula> monitor;
  };
  static constexpr Nanoseconds kUnknown = -1;

  void add(std::size_t property, const Monitored& of, Nanoseconds unit);
  Decision begin(Watch& watch, const verify::Word* state);
  Decision take(Watch& watch, const Taken& step);
  Decision stay(Watch& watch, const verify::Word* state, Nanoseconds until);
  [[nodiscard]] Decision decisionOf(const Watch& watch, Nanoseconds date) const;
  [[nodiscard]] bool isReached(const verify::Goal& goal, const Taken& step) const;

  /// Moves each monitor that is not decided yet. `move` returns its decision.
  template <class Move> void eachOpen(Move&& move, const Decided& decided);

  const verify::System& system;
  const std::vector<Monitored>& properties;
  std::list<Watch> open; ///< not decided yet
  std::vector<Decision> decisions;
  verify::Bits events;             ///< of the step
  Nanoseconds deadline = kUnknown; ///< of the current state; kUnknown: not computed
};

} // namespace proskill::runtime
