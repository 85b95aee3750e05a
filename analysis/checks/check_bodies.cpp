#include "analysis/checks/checks.h"

#include "analysis/checks/cases.h"
#include "analysis/checks/message.h"
#include "analysis/names/arguments.h"
#include "analysis/names/expressions.h"
#include "analysis/names/walk.h"
#include "syntax/diagnostics/codes.h"

#include <utility>

namespace proskill::analysis {

using syntax::Code;
using syntax::Statement;
using syntax::StatementKind;

namespace {

/// Checks what a body may do: a skill acts; an environment only generates what the program cannot
/// control.
class BodyCheck {
public:
  BodyCheck(Context& context, const Body& body)
      : context(context),
        body(body),
        names(context, body.file),
        expressions(context, body.file, isSkill() ? body.owner : kNoSymbol) {}

  void check(const Statement& statement) {
    if (isSkill() ? isForSkills(statement) : isForEnvironments(statement)) resolve(statement);
  }

private:
  [[nodiscard]] bool isSkill() const {
    return context.symbols[body.owner].kind == SymbolKind::Skill;
  }

  bool isForSkills(const Statement& statement) {
    const bool allowed =
        statement.kind != StatementKind::Emit && statement.kind != StatementKind::Choose;
    return allowed || refuse(Code::OnlyInEnvironment, statement.head);
  }

  bool isForEnvironments(const Statement& statement) {
    switch (statement.kind) {
    case StatementKind::Call:
    case StatementKind::Set:
    case StatementKind::Parallel:
    case StatementKind::Race:
    case StatementKind::Success:
    case StatementKind::Failure: return refuse(Code::NotInEnvironment, statement.head);
    case StatementKind::WaitCondition:
      if (statement.effects.items.empty()) return true;
      expressions.condition(statement.condition);
      return refuse(Code::NotInEnvironment, {":effects", statement.effects.range});
    case StatementKind::Unknown:
    case StatementKind::Interrupt:
    case StatementKind::WaitTime:
    case StatementKind::If:
    case StatementKind::Case: // as part of its call
    case StatementKind::While:
    case StatementKind::DoUntil:
    case StatementKind::Break:
    case StatementKind::Label:
    case StatementKind::Goto:
    case StatementKind::Printf:
    case StatementKind::Emit:
    case StatementKind::Choose: return true;
    }
    std::unreachable();
  }

  bool refuse(syntax::CodeFor<1> code, const syntax::Name& word) {
    context.findings.report(code, {body.file, word.range}, word.text);
    return false;
  }

  /// `(^ word)`: a word is not a condition, so a constant was meant.
  [[nodiscard]] bool isLoneWord(const Statement& statement) const {
    const auto& condition = statement.condition;
    return condition.kind == syntax::ExprKind::Symbol && statement.branches.empty() &&
           context.symbols.find(SymbolKind::StateVariable, condition.name.text) == kNoSymbol;
  }

  void useConstant(const syntax::Name& name) { names.use(SymbolKind::Constant, name, Role::Read); }

  void resolve(const Statement& statement) {
    switch (statement.kind) {
    case StatementKind::Call: return call(statement);
    case StatementKind::Interrupt: return interrupt(statement.name);
    case StatementKind::WaitCondition:
      if (isLoneWord(statement)) return useConstant(statement.condition.name);
      [[fallthrough]];
    case StatementKind::While:
    case StatementKind::DoUntil:
    case StatementKind::Set:
      expressions.condition(statement.condition);
      expressions.effects(statement.effects);
      return;
    case StatementKind::If:
      for (const syntax::Arm& arm : statement.arms)
        if (arm.condition) expressions.condition(*arm.condition);
      return;
    case StatementKind::Case: return checkCase(context, body, statement);
    case StatementKind::Printf: return checkMessage(context, body, statement);
    case StatementKind::Success: return outcome(SymbolKind::SuccessTag, statement.name);
    case StatementKind::Failure: return outcome(SymbolKind::FailureTag, statement.name);
    case StatementKind::Emit: return emit(statement.name);
    case StatementKind::Unknown:
    case StatementKind::WaitTime:
    case StatementKind::Break:
    case StatementKind::Label:
    case StatementKind::Goto:
    case StatementKind::Parallel:
    case StatementKind::Race:
    case StatementKind::Choose: return;
    }
  }

  /// An event with `:every` occurs by itself only.
  void emit(const syntax::Name& name) {
    names.use(SymbolKind::Event, name, Role::Mention);
    const auto* event = context.program.events.find(name.text);
    if (!event || !(*event)->every) return;
    context.findings.report(Code::EmitsEvery, {body.file, name.range}, name.text)
        .related(event->at((*event)->every->range), "says when it comes");
  }

  void outcome(SymbolKind kind, const syntax::Name& tag) {
    names.use(kind, tag, Role::Mention, body.owner);
  }

  void call(const Statement& statement) {
    const SymbolId callee = names.use(SymbolKind::Skill, statement.head, Role::Call);
    if (callee == kNoSymbol) return context.findings.forgetArguments({body.file, statement.range});
    const auto& skill = context.program.skills.all[context.symbols[callee].definition];
    if (skill->monitor)
      context.findings
          .report(Code::MonitorCalled, {body.file, statement.head.range}, statement.head.text)
          .related(skill.at(skill->name.range), "a monitor");
    else
      Arguments(context, body.file, body.owner).checkCall(statement, callee);
  }

  /// Interrupting a skill that cannot be interrupted has no effect in a body; in an environment it
  /// is impossible.
  void interrupt(const syntax::Name& target) {
    const SymbolId symbol = names.use(SymbolKind::Skill, target, Role::Interrupt);
    if (symbol == kNoSymbol) return;
    const auto& skill = context.program.skills.all[context.symbols[symbol].definition];
    if (skill->interrupt) return;
    auto finding =
        context.findings.report(Code::NotInterruptible, {body.file, target.range}, target.text);
    finding.related(skill.at(skill->name.range),
                    skill->unstoppable ? "is `:interruptible nil`" : "has no `:interrupt`");
    if (!isSkill()) finding.severity(syntax::Severity::Error);
  }

  Context& context;
  const Body& body;
  Names names;
  Expressions expressions;
};

} // namespace

void checkBodies(Context& context) {
  context.eachBody([&](const Body& body) {
    BodyCheck check(context, body);
    forEachStatement(body.block, [&](const Statement& statement) { check.check(statement); });
  });
}

} // namespace proskill::analysis
