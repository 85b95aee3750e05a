#include "fiacre/check/check_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace proskill::fiacre {
namespace {

/// Target of a path: a process, a component, or a composition within one.
struct Target {
  const Process* process = nullptr;
  const Component* component = nullptr;
  const std::vector<Instance>* parts = nullptr; ///< null for a process
};

std::optional<Target> find(const std::string& name, const Declarations& known) {
  if (const auto* process = lookUp(known.processes, name)) return Target{.process = *process};
  if (const auto* component = lookUp(known.components, name))
    return Target{.component = *component, .parts = &(*component)->instances};
  return std::nullopt;
}

std::optional<Target> find(const Instance& instance, const Declarations& known) {
  if (!instance.parts.empty()) return Target{.parts = &instance.parts};
  return find(instance.process, known);
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
      report("a time must not be negative");
    if (pattern.kind == PatternKind::Ltl) check(pattern.ltl);
  }

  void check(const Observable& o) const {
    for (const auto& operand : o.operands) check(operand);
    switch (o.kind) {
    case ObservableKind::State: return atTarget(o, [&](const auto& at) { state(at, o.name); });
    case ObservableKind::Value: return atTarget(o, [&](const auto& at) { value(at, o.value); });
    case ObservableKind::Tag: return atTarget(o, [&](const auto& at) { tag(at, o.name); });
    case ObservableKind::Event: return atTarget(o, [&](const auto& at) { event(at, o.name); });
    case ObservableKind::Enter:
    case ObservableKind::Leave:
    case ObservableKind::Not:
    case ObservableKind::And:
    case ObservableKind::Or:
    case ObservableKind::Implies: return;
    }
  }

private:
  template <class Check> void atTarget(const Observable& o, Check&& check) const {
    if (const auto target = follow(o)) check(*target);
  }

  void operands(const Pattern& pattern) const {
    std::size_t wanted = 1;
    switch (pattern.kind) {
    case PatternKind::DeadlockFree: // its observable says where the model may stop
      wanted = pattern.operands.empty() ? 0 : 1;
      break;
    case PatternKind::Progress:
    case PatternKind::NoError:
    case PatternKind::Ltl: wanted = 0; break;
    case PatternKind::LeadsTo:
    case PatternKind::Precedes:
    case PatternKind::Longest:
    case PatternKind::Shortest: wanted = 2; break;
    case PatternKind::InfinitelyOften:
    case PatternKind::Mortal:
    case PatternKind::Present:
    case PatternKind::Absent:
    case PatternKind::Always:
    case PatternKind::AlwaysReachable: break;
    }
    if (pattern.operands.size() != wanted)
      report(fmt::format("the pattern has {} operands, not {}", pattern.operands.size(), wanted));
  }

  void check(const Ltl& ltl) const {
    if (ltl.kind == LtlKind::Atom) check(ltl.atom);
    for (const auto& operand : ltl.operands) check(operand);
  }

  /// Resolves a path from the main component or an observer, by positions in `par`.
  [[nodiscard]] std::optional<Target> follow(const Observable& o) const {
    const auto& begin = o.observer.empty() ? program.main : o.observer;
    auto target = find(begin, known);
    for (auto place : o.path) {
      const auto* parts = target ? target->parts : nullptr;
      if (!parts || place == 0 || place > parts->size()) {
        report(fmt::format("the path {}/{} leads nowhere", begin, fmt::join(o.path, "/")));
        return std::nullopt;
      }
      target = find((*parts)[place - 1], known);
    }
    return target;
  }

  void state(const Target& target, const std::string& name) const {
    if (!target.process)
      return report(fmt::format("`state {}` does not belong to a process", name));
    if (std::ranges::find(target.process->states, name, &State::name) ==
        target.process->states.end())
      report(fmt::format("process {} has no state `{}`", target.process->name, name));
  }

  void value(const Target& target, const Expr& expr) const {
    if (!target.process && !target.component)
      return report("`value` refers to a composition without a name: name a part of it");
    const auto scope = target.process
                           ? scopeOf(target.process->parameters, target.process->variables)
                           : scopeOf(target.component->parameters, target.component->variables);
    Typing(known, scope, report).expectBool(expr);
  }

  void tag(const Target& target, const std::string& name) const {
    if (!target.process) return report(fmt::format("`tag {}` does not belong to a process", name));
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

bool namesObserver(const Observable& o) {
  return !o.observer.empty() || std::ranges::any_of(o.operands, namesObserver);
}

} // namespace

bool watchesSteps(const Observable& observable) {
  switch (observable.kind) {
  case ObservableKind::Tag:
  case ObservableKind::Event:
  case ObservableKind::Enter:
  case ObservableKind::Leave: return true;
  case ObservableKind::State:
  case ObservableKind::Value:
  case ObservableKind::Not:
  case ObservableKind::And:
  case ObservableKind::Or:
  case ObservableKind::Implies: return std::ranges::any_of(observable.operands, watchesSteps);
  }
  std::unreachable();
}

void checkProbe(const Port& port, const Program& program, const Declarations& known,
                const Report& report) {
  if (!port.probe) return;
  PropertyCheck(program, known, report).check(*port.probe);
  const auto said = [&](std::string_view what) {
    report(fmt::format("the probe of `{}` {}", port.name, what));
  };
  if (namesObserver(*port.probe)) said("refers to an observer: a probe can only observe the model");
  if (!watchesSteps(*port.probe)) return;
  if (!port.values.empty()) said("observes steps and cannot carry values");
  if (port.interval && (port.interval->lower != 0 || port.interval->upper.value_or(0) != 0))
    said("observes steps: it is passed with them and cannot have an interval of its own");
}

void checkProperty(const Property& property, const Program& program, const Declarations& known,
                   const Report& report) {
  PropertyCheck(program, known, report).run(property.pattern);
}

} // namespace proskill::fiacre
