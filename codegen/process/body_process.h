#pragma once

#include "codegen/process/calls.h"
#include "codegen/process/skill_frame.h"

#include <functional>

namespace proskill::codegen {

/// Translates a body to states and transitions of a process. Skills, branches and environments
/// override what they do at their end and what may end them early.
class BodyProcess {
public:
  BodyProcess(Context& context, const BodyAutomaton& body, Actor actor, fiacre::Expr me);
  virtual ~BodyProcess() = default;

protected:
  void addBody(fiacre::Process& process);

  /// Further transitions of a state in which time can pass while these skills or branches run for
  /// this body.
  virtual std::vector<fiacre::Statement>
  abortStatements(const std::vector<std::string_view>& running, bool joining) = 0;
  /// The transition at the end of the body; null: it stays there.
  virtual std::optional<fiacre::Statement> atEnd() = 0;
  /// The translation of `(success tag)` and `(failure tag)`.
  virtual fiacre::Statement conclude(const syntax::Statement& statement) = 0;
  /// The translation of `(x.interrupt)`.
  virtual fiacre::Statement interrupt(const BodyState& state);
  /// The body takes no step while this is false: a guard of its skill is false.
  virtual fiacre::Expr mayStep() { return boolean(true); }
  /// Further transitions of states without time while the body may take no step.
  virtual std::vector<fiacre::Statement> abortStatementsWhereHeld() { return {}; }
  /// True until a branch has ended the skill.
  virtual fiacre::Expr mayGoOn() { return boolean(true); }

  /// Records how a stopped callee of this body ended, as the skill continues.
  [[nodiscard]] fiacre::Statement keepOutcomeOfStopped(std::string_view callee);

  [[nodiscard]] OriginId origin(syntax::Range range, std::string_view words = {}) {
    return context.origins.of(actor, range, words);
  }

  Context& context;
  const BodyAutomaton& body;
  Actor actor;
  Calls calls;

private:
  void addStatement(fiacre::Process& process, const BodyState& state);
  void addCall(fiacre::Process& process, const BodyState& state);
  void addParallel(fiacre::Process& process, const BodyState& state);
  void addWaiting(fiacre::Process& process, const BodyState& state, fiacre::Statement main);
  /// A statement that waits for `main` or for something that ends the body meanwhile.
  [[nodiscard]] static fiacre::Statement watched(fiacre::Statement main,
                                                 std::vector<fiacre::Statement> abortStatements);
  [[nodiscard]] fiacre::Statement unlessHeld(fiacre::Statement step);
  [[nodiscard]] fiacre::Statement whenItMay(fiacre::Statement main);
  [[nodiscard]] fiacre::Statement waitFor(const BodyState& state);
  [[nodiscard]] fiacre::Statement timeOut(const BodyState& state);
  [[nodiscard]] fiacre::Statement step(const BodyState& state);
  [[nodiscard]] fiacre::Statement callNow(const BodyState& state, const std::string& sync);
  [[nodiscard]] fiacre::Expr argumentsOf(const syntax::Statement& call);
  [[nodiscard]] fiacre::Statement keepOutcome(std::string_view callee);
  void eachOutcomeField(std::string_view callee,
                        const std::function<void(const fiacre::Expr&, fiacre::Expr)>& visit);
  [[nodiscard]] fiacre::Statement returnFrom(const BodyState& state);
  [[nodiscard]] fiacre::Statement goOnAfter(const BodyState& state, const SkillPlan& callee,
                                            syntax::Range range, const std::string& target);
  [[nodiscard]] fiacre::Statement chooseArm(const BodyState& state, const SkillPlan& callee);
  [[nodiscard]] fiacre::Statement join(const BodyState& state);
  [[nodiscard]] fiacre::Statement testArms(const BodyState& state);
  [[nodiscard]] fiacre::Statement testLoop(const BodyState& state);
  [[nodiscard]] fiacre::Statement choose(const BodyState& state);
  [[nodiscard]] fiacre::Statement tested(syntax::Range range, bool value,
                                         const std::string& target);
  [[nodiscard]] std::string lineOf(const BodyState& state) const;
  [[nodiscard]] std::string excerpt(syntax::Range range) const;
  [[nodiscard]] std::string quote(syntax::Range range) const;
};

/// The process of a composite skill's body or of one of its branches.
[[nodiscard]] const std::string& processOf(Context& context, const SkillPlan& skill,
                                           const BodyAutomaton& thread);

/// Names of states: `syncState` waits for a call or for parallel branches to end, `busyState` for
/// the called skill to be free.
[[nodiscard]] std::string syncState(const BodyState& state);
[[nodiscard]] std::string busyState(const BodyState& state);

/// The control states before and within the statement of a body's state.
[[nodiscard]] std::vector<std::string> statesOf(const Context& context, const BodyState& state);

} // namespace proskill::codegen
