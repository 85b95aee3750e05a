#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// A way in which a skill can end.
struct Ending {
  std::string status; ///< `success`, `failed_inv`, …
  syntax::Name tag;   ///< of the outcome or the invariant; empty if it has none
  const syntax::Effects* effects = nullptr;
  const syntax::Expr* postcondition = nullptr;
  syntax::Range range;
  std::string description; ///< "succeeds with `at_altitude`"
  bool wasNoticed = false; ///< an earlier step has reported why
};

[[nodiscard]] Ending successOf(const SkillPlan& skill, std::string_view tag);
[[nodiscard]] Ending failureOf(const SkillPlan& skill, std::string_view tag);
[[nodiscard]] Ending interruptionOf(const SkillPlan& skill);
/// The same if it comes through a port.
[[nodiscard]] Ending outsideInterruptionOf(const SkillPlan& skill);
[[nodiscard]] Ending failureOf(const syntax::Invariant& invariant);
/// The outcomes that a skill declares. A basic skill without a success gets one without a tag.
[[nodiscard]] std::vector<Ending> outcomesOf(const SkillPlan& skill);

/// How a skill starts, is refused and ends; the same for basic and composite skills. The expanded
/// edition puts a state before and after these transitions, so that each one can be named; what is
/// atomic in the compact edition is atomic there too.
class SkillFrame {
public:
  SkillFrame(Context& context, const SkillPlan& skill);

  /// Adds the states and transitions from a call to `first`, where the skill runs.
  void addStart(fiacre::Process& process, std::string_view first);
  /// The end of the skill, up to `to idle`.
  [[nodiscard]] fiacre::Statement end(const Ending& ending);
  /// The same in two parts: what is specific to this ending, and what all endings share. Compact
  /// edition.
  [[nodiscard]] fiacre::Statement outcome(const Ending& ending);
  [[nodiscard]] fiacre::Statement giveBack();
  /// Adds the states after the endings that were used, up to the state that awaits the next call.
  void addRest(fiacre::Process& process, std::string_view start = "start_");

  /// The invariant is false.
  [[nodiscard]] fiacre::Expr fails(const syntax::Invariant& invariant);
  /// The skill was asked to stop.
  [[nodiscard]] fiacre::Expr stop() { return cell("stop"); }
  [[nodiscard]] fiacre::Expr cell(std::string_view field) {
    return context.cellField(skill.name(), field);
  }
  [[nodiscard]] OriginId origin(syntax::Range range, std::string_view words = {}) {
    return context.origins.of(actor, range, words);
  }
  /// The same, with the reason why the invariant fails.
  OriginId failsAt(OriginId words, const syntax::Invariant& invariant);
  [[nodiscard]] OriginId place() { return origin(skill.skill().name.range); }

private:
  [[nodiscard]] fiacre::Statement entry(std::string_view satisfied, std::string_view refused,
                                        std::string_view stopped);
  [[nodiscard]] fiacre::Statement start(std::string_view next);
  [[nodiscard]] fiacre::Statement refuse(std::string_view next);
  [[nodiscard]] fiacre::Statement refusal();
  [[nodiscard]] fiacre::Statement stopEarly(std::string_view next);
  [[nodiscard]] fiacre::Statement interruptEarly(std::string_view next);
  [[nodiscard]] fiacre::Statement returnInterrupted(std::string_view words, std::string_view next);
  [[nodiscard]] fiacre::Statement orInterrupted(fiacre::Statement entry, std::string_view stopped);
  [[nodiscard]] fiacre::Expr isCalled();
  [[nodiscard]] fiacre::Expr isReady();
  [[nodiscard]] fiacre::Expr isFree(std::string_view resource) const;
  [[nodiscard]] OriginId waitsOf(OriginId begins);
  [[nodiscard]] OriginId groundsOf(const Ending& ending);
  [[nodiscard]] std::string quote(syntax::Range range) const;
  [[nodiscard]] fiacre::Statement happens(const Ending& ending);
  [[nodiscard]] fiacre::Statement checkPostcondition(const Ending& ending);
  [[nodiscard]] fiacre::Statement postconditionFails(const Ending& ending);
  [[nodiscard]] fiacre::Statement report(const Ending& ending);
  [[nodiscard]] fiacre::Statement setResult(std::string_view status, std::string_view tag);
  [[nodiscard]] fiacre::Statement returnControl();
  [[nodiscard]] fiacre::Statement changeResources(fiacre::Op op);
  [[nodiscard]] static std::string stateAfter(const Ending& ending);
  void noteEndState(const std::string& state, const Ending& ending);
  void addEndStates(fiacre::Process& process);
  [[nodiscard]] std::string restingState() const;
  void addEnded(fiacre::Process& process, std::string_view start);
  [[nodiscard]] fiacre::Statement rearm(std::string_view start);
  void step(fiacre::Process& process, std::string_view from, std::string_view next,
            std::string_view comment);

  Context& context;
  const SkillPlan& skill;
  Actor actor;
  /// Expanded edition: the states that are used.
  std::vector<std::pair<std::string, Ending>> endStates;
};

/// Adds a state with its transitions.
void addState(fiacre::Process& process, std::string_view name, OriginId origin,
              fiacre::Statement statement, std::string comment = {});

} // namespace proskill::codegen
