#include "fiacre/check_parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::fiacre {
namespace {

/// Where a path of a property leads: to a process or to a component.
struct Target {
  const Process* process = nullptr;
  const Component* component = nullptr;
};

std::optional<Target> find(const std::string& name, const Declarations& known) {
  if (const auto* process = lookUp(known.processes, name)) return Target{*process, nullptr};
  if (const auto* component = lookUp(known.components, name)) return Target{nullptr, *component};
  return std::nullopt;
}

bool bears(const Statement& statement, const std::string& tag) {
  return (statement.kind == StatementKind::Tag && statement.name == tag) ||
         std::ranges::any_of(statement.children,
                             [&](const Statement& child) { return bears(child, tag); });
}

class PropertyCheck {
public:
  PropertyCheck(const Program& checked, const Declarations& declared, const Report& to)
      : program(checked), known(declared), report(to) {}

  void run(const Pattern& pattern) const {
    operands(pattern);
    for (const auto& observable : pattern.operands) check(observable);
    if (pattern.after) check(*pattern.after);
    if (pattern.before) check(*pattern.before);
    if (pattern.until) check(*pattern.until);
    if (pattern.within) checkInterval(*pattern.within, report);
    if (pattern.forInterval) checkInterval(*pattern.forInterval, report);
    if (pattern.lasting.value_or(0) < 0 || pattern.forDuration.value_or(0) < 0)
      report("a time is negative");
    if (pattern.kind == PatternKind::Ltl) check(pattern.ltl);
  }

private:
  void operands(const Pattern& pattern) const {
    std::size_t wanted = 1;
    switch (pattern.kind) {
    case PatternKind::DeadlockFree: // where it may stop, if anywhere
      wanted = pattern.operands.empty() ? 0 : 1;
      break;
    case PatternKind::Progress:
    case PatternKind::NoError:
    case PatternKind::Ltl: wanted = 0; break;
    case PatternKind::LeadsTo:
    case PatternKind::Precedes: wanted = 2; break;
    default: break;
    }
    if (pattern.operands.size() != wanted)
      report(fmt::format("the pattern has {} operands, not {}", pattern.operands.size(), wanted));
  }

  void check(const Ltl& ltl) const {
    if (ltl.kind == LtlKind::Atom) check(ltl.atom);
    for (const auto& operand : ltl.operands) check(operand);
  }

  void check(const Observable& o) const {
    for (const auto& operand : o.operands) check(operand);
    if (o.kind > ObservableKind::Event) return;
    const auto target = follow(o.path);
    if (!target) return;
    switch (o.kind) {
    case ObservableKind::State: return state(*target, o.name);
    case ObservableKind::Value: return value(*target, o.value);
    case ObservableKind::Tag: return tag(*target, o.name);
    default: return event(*target, o.name);
    }
  }

  /// From the main component down, by places in `par`.
  [[nodiscard]] std::optional<Target> follow(const std::vector<std::uint32_t>& path) const {
    auto target = find(program.main, known);
    for (auto place : path) {
      const auto* component = target ? target->component : nullptr;
      if (!component || place == 0 || place > component->instances.size()) {
        report(fmt::format("the path {}/{} leads nowhere", program.main, fmt::join(path, "/")));
        return std::nullopt;
      }
      target = find(component->instances[place - 1].process, known);
    }
    return target;
  }

  void state(const Target& target, const std::string& name) const {
    if (!target.process) return report(fmt::format("`state {}` is of no process", name));
    if (std::ranges::find(target.process->states, name, &State::name) ==
        target.process->states.end())
      report(fmt::format("process {} has no state `{}`", target.process->name, name));
  }

  void value(const Target& target, const Expr& expr) const {
    const auto scope = target.process
                           ? scopeOf(target.process->parameters, target.process->variables)
                           : scopeOf(target.component->parameters, target.component->variables);
    Typing(known, scope, report).expectBool(expr);
  }

  void tag(const Target& target, const std::string& name) const {
    if (!target.process) return report(fmt::format("`tag {}` is of no process", name));
    if (std::ranges::none_of(target.process->transitions,
                             [&](const From& from) { return bears(from.statement, name); }))
      report(fmt::format("process {} has no tag `{}`", target.process->name, name));
  }

  void event(const Target& target, const std::string& name) const {
    const auto declares = [&](const std::vector<Port>& ports) {
      return std::ranges::find(ports, name, &Port::name) != ports.end();
    };
    if (!target.component || !declares(target.component->ports))
      report(fmt::format("the path to the event `{}` names no component that declares it", name));
  }

  const Program& program;
  const Declarations& known;
  const Report& report;
};

} // namespace

void checkProperty(const Property& property, const Program& program, const Declarations& known,
                   const Report& report) {
  PropertyCheck(program, known, report).run(property.pattern);
}

} // namespace proskill::fiacre
