#include "runtime/machine/executable.h"

#include "runtime/machine/monitored.h"
#include "verify/compile/compile.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace proskill::runtime {

namespace {

using verify::kNone;

/// Thrown if a program cannot be executed, for example if its unit of time is not a whole number of
/// nanoseconds.
struct Refused {
  NotExecutable error;
};

Span spanOfInterval(const fiacre::Interval& interval, Nanoseconds unit) {
  Span span{.first = interval.lower * unit + (interval.lowerOpen ? 1 : 0), .last = {}};
  if (interval.upper) span.last = *interval.upper * unit - (interval.upperOpen ? 1 : 0);
  if (span.last && *span.last < span.first)
    throw Refused{{"an interval that contains no whole nanosecond", {}}};
  return span;
}

Span datesOfStep(const fiacre::Interval& interval, Nanoseconds unit) {
  auto span = spanOfInterval(interval, unit);
  if (!interval.lowerOpen) return span;
  span.first = soonAfter(span.first - 1, span.last);
  return span;
}

class Maker {
public:
  Maker(Executable& to, verify::System system) : made(to) { made.system = std::move(system); }

  void make() {
    findUnit();
    for (const auto& performed : made.model.performed) made.actions.push_back(actionOf(performed));
    for (const auto& measured : made.model.measured) made.stretches.push_back(stretchOf(measured));
    for (const auto& signal : made.model.signals) {
      made.signalPorts.push_back(portOf(signal.port));
      auto& span = made.everySpans.emplace_back();
      if (signal.every && !made.model.hasEnvironment)
        span = spanOfInterval(*signal.every, made.unit);
    }
    findMission();
    findRoles();
    for (const auto& [origin, message] : made.model.messages)
      for (const auto& part : message) made.messages[origin].push_back(partOf(part));
    made.isAlarm.assign(made.model.provenance.origins.size(), false);
    for (const auto& [origin, alarm] : made.model.alarms) made.isAlarm[origin] = true;
  }

private:
  void findUnit() {
    const auto unit = made.model.unit;
    if (unit.denominator > kSecond || kSecond % unit.denominator != 0)
      throw Refused{
          {fmt::format("{} s is not a whole number of nanoseconds", syntax::toString(unit)), {}}};
    made.unit = unit.numerator * (kSecond / unit.denominator);
  }

  /// Each process has exactly one instance.
  [[nodiscard]] verify::InstanceId instanceOf(const std::string& process) const {
    const auto& all = made.system.instances;
    for (verify::InstanceId i = 0; i < all.size(); ++i)
      if (all[i].name == process + "_1") return i;
    return kNone;
  }

  [[nodiscard]] std::uint32_t portOf(const std::string& name) const {
    const auto found = std::ranges::find(made.system.ports, name);
    if (found == made.system.ports.end()) return kNone;
    return static_cast<std::uint32_t>(found - made.system.ports.begin());
  }

  [[nodiscard]] std::int64_t locationOf(verify::InstanceId instance, std::string_view name) const {
    const auto& all = made.system.instances[instance].locations;
    const auto found = std::ranges::find(all, name);
    return found == all.end() ? std::int64_t{kNone} : found - all.begin();
  }

  [[nodiscard]] Action actionOf(const codegen::Performed& performed) const {
    Action action;
    action.instance = instanceOf(performed.process);
    action.idle = locationOf(action.instance, "idle");
    action.run = locationOf(action.instance, "run");
    for (const auto& result : performed.results) action.resultPorts.push_back(portOf(result.port));
    action.unknownPort = portOf(performed.unknownPort);
    action.stoppedPort = performed.stoppedPort.empty() ? kNone : portOf(performed.stoppedPort);
    if (performed.interval) action.span = spanOfInterval(*performed.interval, made.unit);
    const auto& watched = made.system.watched;
    const auto cell =
        std::ranges::find(watched, performed.numberCell, &verify::WatchedCell::display);
    action.number = cell == watched.end() ? kNone : cell->cell;
    for (std::size_t i = 0; i < made.model.actionCalls.size(); ++i) {
      const auto& call = made.model.actionCalls[i];
      if (call.skill != performed.skill) continue;
      const auto number = static_cast<std::size_t>(call.number);
      if (action.calls.size() <= number) action.calls.resize(number + 1, SIZE_MAX);
      action.calls[number] = i;
    }
    return action;
  }

  [[nodiscard]] Stretch stretchOf(const codegen::Measured& measured) const {
    const auto instance = instanceOf(measured.process);
    return {.instance = instance,
            .idle = locationOf(instance, "idle"),
            .ended = locationOf(instance, "ended"),
            .span = spanOfInterval(measured.interval, made.unit)};
  }

  [[nodiscard]] MessagePart partOf(const codegen::MessagePart& part) const {
    MessagePart to{part.text, {}, part.constant, part.isValue};
    const auto& all = made.system.watched;
    for (const auto& [factor, variable] : part.terms) {
      const auto found = std::ranges::find(all, variable, &verify::WatchedCell::display);
      if (found == all.end()) return {"?", {}};
      to.terms.push_back({factor, static_cast<std::uint32_t>(found - all.begin())});
    }
    return to;
  }

  void findMission() {
    if (made.model.missionProcess.empty()) return;
    made.mission = instanceOf(made.model.missionProcess);
    made.missionEnded = locationOf(made.mission, "ended");
  }

  void findRoles() {
    std::vector<bool> external(made.system.ports.size(), false);
    const auto add = [&](std::uint32_t port) {
      if (port != kNone) external[port] = true;
    };
    for (const auto& action : made.actions) {
      for (const auto port : action.resultPorts) add(port);
      add(action.unknownPort);
      add(action.stoppedPort);
    }
    if (!made.model.hasEnvironment)
      for (const auto port : made.signalPorts) add(port);
    made.atPort.resize(made.system.ports.size());
    for (verify::TransitionId id = 0; id < made.system.transitions.size(); ++id) {
      made.handling.push_back(handlingOf(id, external));
      if (made.handling.back().role == Role::External)
        made.atPort[made.system.transitions[id].port].push_back(id);
    }
  }

  [[nodiscard]] Handling handlingOf(verify::TransitionId id,
                                    const std::vector<bool>& external) const {
    const auto& transition = made.system.transitions[id];
    Handling handling;
    bool drawn = false;
    for (const auto part : transition.parts) {
      const auto instance = made.system.paths[part].instance;
      for (std::uint32_t i = 0; i < made.actions.size(); ++i)
        if (made.actions[i].instance == instance) handling.action = i;
      for (std::uint32_t i = 0; i < made.stretches.size(); ++i)
        if (made.stretches[i].instance == instance) handling.stretch = i;
      drawn = drawn || isOfEnvironment(instance);
    }
    if (transition.port != kNone && external[transition.port])
      handling.role = Role::External;
    else if (!transition.urgent)
      handling.role = drawn ? Role::Drawn : Role::Timed;
    if (handling.role != Role::External)
      handling.span = datesOfStep(transition.interval, made.unit);
    return handling;
  }

  [[nodiscard]] bool isOfEnvironment(verify::InstanceId instance) const {
    const auto& name = made.system.instances[instance].name;
    return std::ranges::any_of(made.model.drawnProcesses,
                               [&](const auto& process) { return name == process + "_1"; });
  }

  Executable& made;
};

/// Compiles a model with its questions. A question that the engine does not support gets a goal
/// that says so.
std::expected<verify::Compiled, verify::Unsupported>
compileAsked(const fiacre::Program& program, const fiacre::Provenance& provenance,
             const std::vector<verify::Question>& questions) {
  auto whole = verify::compile(program, provenance, questions);
  if (whole || questions.empty()) return whole;
  std::vector<verify::Question> possible;
  std::vector<std::string> reasons;
  for (const auto& question : questions) {
    auto alone = verify::compile(program, provenance, {question});
    reasons.push_back(alone ? "" : alone.error().message);
    if (alone) possible.push_back(question);
  }
  auto made = verify::compile(program, provenance, possible);
  if (!made) return made;
  auto goal = made->goals.begin();
  std::vector<verify::Goal> all;
  for (const auto& reason : reasons)
    all.push_back(reason.empty()
                      ? std::move(*goal++)
                      : verify::Goal{.kind = verify::GoalKind::Unsupported, .reason = reason});
  made->goals = std::move(all);
  return made;
}

} // namespace

Nanoseconds soonAfter(Nanoseconds bound, const std::optional<Nanoseconds>& last) {
  const auto later = bound + kSecond / 1000;
  return last ? std::min(later, std::midpoint(bound, *last + 1)) : later;
}

const codegen::ActionCall* Executable::callOf(std::uint32_t action,
                                              const verify::Word* state) const {
  const auto& of = actions[action];
  const auto number = of.number == kNone ? 0 : verify::readCell(system, of.number, state);
  const auto index = static_cast<std::size_t>(number);
  if (index >= of.calls.size() || of.calls[index] == SIZE_MAX) return nullptr;
  return &model.actionCalls[of.calls[index]];
}

std::expected<std::unique_ptr<const Executable>, NotExecutable>
makeExecutable(const analysis::Program& program, const std::string& mainSkill, bool environment) {
  auto model = codegen::generate(
      program,
      {.edition = codegen::Edition::Executed, .mainSkill = mainSkill, .environment = environment});
  if (!model) return std::unexpected(std::move(model.error()));
  auto made = std::make_unique<Executable>();
  made->model = std::move(*model);
  const auto questions = addNegations(made->model);
  auto provenance = made->model.provenance;
  for (const auto& performed : made->model.performed)
    provenance.watched.push_back({performed.numberCell, performed.numberCell, {}});
  auto compiled = compileAsked(made->model.fiacre, provenance, questions);
  if (!compiled) return std::unexpected(NotExecutable{compiled.error().message, {}});
  try {
    made->properties = monitored(made->model, compiled->goals);
    Maker(*made, verify::withStateLayout(std::move(compiled->system))).make();
  } catch (Refused& refused) {
    return std::unexpected(std::move(refused.error));
  }
  made->enabling.emplace(made->system);
  const auto isNumber = [&](const verify::WatchedCell& cell) {
    return std::ranges::any_of(made->model.performed, [&](const auto& performed) {
      return performed.numberCell == cell.display;
    });
  };
  const auto& watched = made->system.watched;
  made->shownVariables =
      static_cast<std::size_t>(std::ranges::find_if(watched, isNumber) - watched.begin());
  return made;
}

} // namespace proskill::runtime
