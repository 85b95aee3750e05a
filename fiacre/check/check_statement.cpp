#include "fiacre/check/check_parts.h"
#include "fiacre/print/print.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::fiacre {
namespace {

/// Checks one statement; `checkNames` checks the statements in it.
class StatementCheck {
public:
  StatementCheck(const Statement& checked, const CheckContext& near, const Report& to)
      : s(checked), around(near), report(to), typing(near.known, near.scope, to) {}

  void run() const {
    switch (s.kind) {
    case StatementKind::Assign: return assign();
    case StatementKind::Any: return any();
    case StatementKind::On:
    case StatementKind::If:
    case StatementKind::While: return typing.expectBool(s.values[0]);
    case StatementKind::Wait: return checkInterval(s.interval, report);
    case StatementKind::To: return to();
    case StatementKind::Case: return cases();
    case StatementKind::Send: return send();
    case StatementKind::Receive: return receive();
    case StatementKind::Start: return start();
    case StatementKind::Sync: return sync();
    case StatementKind::Foreach: return foreach ();
    case StatementKind::Return: return result();
    case StatementKind::Tag: return Names(report).add(s.name, "the tag");
    case StatementKind::Null:
    case StatementKind::Comment:
    case StatementKind::Loop:
    case StatementKind::Select:
    case StatementKind::Sequence: return;
    }
  }

private:
  void assign() const {
    if (s.targets.size() != s.values.size())
      return report(fmt::format("{} variables get {} values", s.targets.size(), s.values.size()));
    for (std::size_t i = 0; i < s.targets.size(); ++i)
      if (const auto type = typing.target(s.targets[i])) typing.expect(s.values[i], *type);
  }

  void targets() const {
    for (const auto& target : s.targets)
      if (!isWild(target)) (void)typing.target(target);
    for (const auto& guard : s.values) typing.expectBool(guard);
  }

  void any() const {
    targets();
    for (const auto& target : s.targets) {
      const auto type = Typing(around.known, around.scope, report).infer(target);
      if (type && (type->kind == TypeKind::Nat || type->kind == TypeKind::Int))
        report(fmt::format("the type of `{}` has too many values for `any`", printLvalue(target)));
    }
  }

  void to() const {
    if (!around.states.contains(s.name))
      report(fmt::format("the state `{}` is not declared", s.name));
  }

  void cases() const {
    const auto type = typing.infer(s.values[0]);
    for (std::size_t i = 1; type && i < s.values.size(); ++i) {
      const auto& pattern = s.values[i];
      const bool rest = isWild(pattern);
      if (!rest) typing.expect(pattern, *type);
      if (rest && i + 1 < s.values.size()) report("no value is left after the pattern `any`");
      if (std::find(s.values.begin() + 1, s.values.begin() + static_cast<std::ptrdiff_t>(i),
                    pattern) != s.values.begin() + static_cast<std::ptrdiff_t>(i))
        report(fmt::format("duplicate pattern `{}`", printExpr(pattern)));
    }
  }

  [[nodiscard]] const Port* port(std::size_t values) const {
    const auto* found = lookUp(around.ports, s.name);
    if (!found) {
      report(fmt::format("the port `{}` is not declared", s.name));
      return nullptr;
    }
    if ((*found)->values.size() == values) return *found;
    report(fmt::format("the port `{}` carries {} values, not {}", s.name, (*found)->values.size(),
                       values));
    return nullptr;
  }

  void send() const {
    const auto* found = port(s.values.size());
    if (!found) return;
    typing.expectAll(s.values, found->values, fmt::format("the port `{}`", s.name));
    if (!found->values.empty() && found->in && !found->out)
      report(fmt::format("the port `{}` is an input", s.name));
  }

  void receive() const {
    const auto* found = port(s.targets.size());
    targets();
    if (found && found->out && !found->in)
      report(fmt::format("the port `{}` is an output", s.name));
    for (std::size_t i = 0; found && i < s.targets.size(); ++i)
      typing.expect(s.targets[i], found->values[i]); // `any` is of every type
  }

  [[nodiscard]] const Task* task() const {
    const auto* found = lookUp(around.known.tasks, s.name);
    if (!found) report(fmt::format("the task `{}` is not declared", s.name));
    return found ? *found : nullptr;
  }

  void start() const {
    if (const auto* found = task())
      typing.expectAll(s.values, found->parameters, fmt::format("the task `{}`", s.name));
  }

  void sync() const {
    const auto* found = task();
    if (!found || s.targets.empty()) return;
    if (typing.target(s.targets[0])) typing.expect(s.targets[0], found->result);
  }

  void foreach () const {
    const auto type = typing.target({.kind = ExprKind::Name, .name = s.name});
    if (!type) return;
    const auto* declared = lookUp(around.known.types, type->name);
    const bool finite =
        type->kind == TypeKind::Range || type->kind == TypeKind::Bool ||
        (type->kind == TypeKind::Named && declared && (*declared)->type.kind == TypeKind::Union);
    if (!finite) report(fmt::format("`{}` cannot iterate over all values of its type", s.name));
  }

  void result() const {
    if (around.result) typing.expect(s.values[0], *around.result);
  }

  const Statement& s;
  const CheckContext& around;
  const Report& report;
  Typing typing;
};

} // namespace

void checkNames(const Statement& statement, const CheckContext& around, const Report& report) {
  const auto here = report.from(statement.origin);
  StatementCheck(statement, around, here).run();
  for (const auto& child : statement.children) checkNames(child, around, here);
}

} // namespace proskill::fiacre
