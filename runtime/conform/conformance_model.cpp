#include "runtime/conform/conformance_model.h"

#include "verify/compile/compile.h"
#include "verify/state/state_layout.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::runtime {

namespace {

using verify::TransitionId;

class ConformanceModelMaker {
public:
  ConformanceModelMaker(ConformanceModel& to, bool environment, Nanoseconds by)
      : made(to), hasEnvironment(environment), tolerance(by) {}

  void make(const codegen::Model& executed) {
    const auto unit = made.model.unit;
    scale = unit.numerator * (kSecond / unit.denominator);
    for (const auto& performed : executed.performed) actions.push_back(performed.process + "_1");
    for (const auto& process : made.model.fiacre.processes)
      if (process.name.starts_with("environment_")) environments.push_back(process.name + "_1");
    for (TransitionId id = 0; id < made.system.transitions.size(); ++id) add(id);
  }

private:
  [[nodiscard]] const std::string& instanceOf(verify::PathId part) const {
    return made.system.instances[made.system.paths[part].instance].name;
  }

  void add(TransitionId id) {
    auto& transition = made.system.transitions[id];
    const auto is = [&](const std::vector<std::string>& names) {
      return std::ranges::all_of(transition.parts, [&](verify::PathId part) {
        return std::ranges::find(names, instanceOf(part)) != names.end();
      });
    };
    const auto isWatchdog = [&](verify::PathId part) {
      return instanceOf(part).ends_with("_watchdog_1");
    };
    const bool ofEnvironment = is(environments);
    made.isHidden.push_back(std::ranges::all_of(transition.parts, isWatchdog) ||
                            (ofEnvironment && !hasEnvironment));
    made.environmentIsHidden = made.environmentIsHidden || (ofEnvironment && !hasEnvironment);
    const bool isResult = is(actions) && transition.port == verify::kNone &&
                          locationOf(transition) == "run" && !isBreak(transition);
    const bool isStop = is(actions) && locationOf(transition).starts_with("stopping_");
    made.isOfAction.push_back(isResult);
    made.isOfEvent.push_back(transition.parts.size() == 1 && transition.port != verify::kNone);
    auto& interval = transition.interval;
    interval.lower *= scale;
    if (interval.upper) *interval.upper *= scale;
    made.promised.push_back(interval);
    if (isResult || isStop || (transition.port != verify::kNone && !hasEnvironment)) {
      interval.lower = std::max<Nanoseconds>(0, interval.lower - tolerance);
      if (interval.upper) *interval.upper += tolerance;
    }
    addOrigins(id);
  }

  [[nodiscard]] const std::string& locationOf(const verify::Transition& transition) const {
    const auto& path = made.system.paths[transition.parts.front()];
    return made.system.instances[path.instance].locations[path.location];
  }

  /// Whether it is a stop request or a failed guard. Those start with a test; results do not.
  [[nodiscard]] bool isBreak(const verify::Transition& transition) const {
    const auto& path = made.system.paths[transition.parts.front()];
    return path.guardReads.count() > 1;
  }

  void addOrigins(TransitionId id) {
    std::vector<std::string> keys;
    for (const auto part : made.system.transitions[id].parts)
      for (const auto& instruction : made.system.paths[part].code)
        if (instruction.kind == verify::InstructionKind::Origin)
          keys.push_back(keyOf(made.model.provenance.origins[instruction.first]));
    std::ranges::sort(keys);
    keys.erase(std::ranges::unique(keys).begin(), keys.end());
    for (auto& key : keys) made.byOrigin[std::move(key)].push_back(id);
  }

  ConformanceModel& made;
  bool hasEnvironment;
  Nanoseconds tolerance;
  Nanoseconds scale = 1;
  std::vector<std::string> actions;
  std::vector<std::string> environments;
};

} // namespace

std::string keyOf(const fiacre::Origin& origin) { return origin.actor + "\n" + origin.description; }

const std::vector<TransitionId>& ConformanceModel::candidates(const RecordedStep& step) const {
  static const std::vector<TransitionId> none;
  const auto found = byOrigin.find(keyOf(step.what));
  return found == byOrigin.end() ? none : found->second;
}

std::expected<std::unique_ptr<const ConformanceModel>, NotExecutable>
conformanceModel(const analysis::Program& program, const Executable& executed,
                 const std::string& mainSkill, bool environment, Nanoseconds tolerance) {
  auto model = codegen::generate(program, {.mainSkill = mainSkill, .separateStops = tolerance > 0});
  if (!model) return std::unexpected(std::move(model.error()));
  auto made = std::make_unique<ConformanceModel>();
  made->model = std::move(*model);
  auto compiled = verify::compile(made->model.fiacre, made->model.provenance, {});
  if (!compiled) return std::unexpected(NotExecutable{compiled.error().message, {}});
  made->system = verify::withStateLayout(std::move(compiled->system));
  ConformanceModelMaker(*made, environment, tolerance).make(executed.model);
  return made;
}

} // namespace proskill::runtime
