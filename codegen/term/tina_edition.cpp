#include "codegen/term/tina_edition.h"

#include "codegen/term/build.h"

#include <algorithm>
#include <map>

namespace proskill::codegen {
namespace {

using fiacre::Observable;
using fiacre::ObservableKind;

/// Maps instances of the main component to their new indices, and keeps the initial states of
/// removed ones.
class Removal {
public:
  explicit Removal(fiacre::Program& of) : program(of) {}

  void run() {
    for (auto& component : program.components)
      if (component.name == program.main) removeInstances(component);
    std::erase_if(program.processes, isIdle);
    if (gone.empty()) return;
    for (auto& property : program.properties) rename(property.pattern);
  }

private:
  static bool isIdle(const fiacre::Process& process) { return process.transitions.empty(); }

  void removeInstances(fiacre::Component& component) {
    std::vector<fiacre::Instance> kept;
    for (std::uint32_t place = 1; auto& instance : component.instances) {
      const auto process =
          std::ranges::find(program.processes, instance.process, &fiacre::Process::name);
      if (process != program.processes.end() && isIdle(*process)) {
        gone.emplace(place, process->states.front().name);
      } else {
        kept.push_back(std::move(instance));
        places.emplace(place, static_cast<std::uint32_t>(kept.size()));
      }
      ++place;
    }
    if (kept.empty() && !component.instances.empty()) return keepOne(component);
    component.instances = std::move(kept);
  }

  /// A component needs an instance, so the first one gets a `from` that is never left.
  void keepOne(fiacre::Component& component) {
    component.instances.resize(1);
    gone.erase(1);
    places.emplace(1, 1);
    auto& process = *std::ranges::find(program.processes, component.instances[0].process,
                                       &fiacre::Process::name);
    const auto& first = process.states.front().name;
    process.transitions.push_back({first, sequence({on(boolean(false)), to(first)})});
  }

  void rename(fiacre::Pattern& pattern) {
    for (auto& operand : pattern.operands) rename(operand);
    for (auto* scope : {&pattern.after, &pattern.before, &pattern.until})
      if (*scope) rename(**scope);
    rename(pattern.ltl);
  }

  void rename(fiacre::Ltl& formula) {
    rename(formula.atom);
    for (auto& operand : formula.operands) rename(operand);
  }

  void rename(Observable& observable) {
    for (auto& operand : observable.operands) rename(operand);
    if (observable.path.empty()) return;
    if (const auto kept = places.find(observable.path[0]); kept != places.end()) {
      observable.path[0] = kept->second;
      return;
    }
    const auto first = gone.find(observable.path[0]);
    if (first == gone.end()) return;
    const bool stays = observable.kind == ObservableKind::State && observable.name == first->second;
    observable = {.kind = ObservableKind::Value, .value = boolean(stays)};
  }

  fiacre::Program& program;
  std::map<std::uint32_t, std::uint32_t> places;
  std::map<std::uint32_t, std::string> gone;
};

} // namespace

void removeIdleProcesses(fiacre::Program& program) { Removal(program).run(); }

} // namespace proskill::codegen
