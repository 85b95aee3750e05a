#include "codegen/term/tina_edition.h"

#include "codegen/term/build.h"

#include <algorithm>
#include <map>

namespace proskill::codegen {
namespace {

using fiacre::Observable;
using fiacre::ObservableKind;

/// Where instances of the main component stand afterwards, and the first states of those that go.
class Removal {
public:
  explicit Removal(fiacre::Program& of) : program(of) {}

  void run() {
    for (auto& component : program.components)
      if (component.name == program.main) removeInstances(component);
    if (gone.empty()) return;
    std::erase_if(program.processes, isIdle);
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
    component.instances = std::move(kept);
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
