#include "verify/trace/step_names.h"

#include <map>

namespace proskill::verify {

std::vector<std::string> stepNames(const System& system) {
  std::vector<std::string> ofPaths;
  std::map<std::string, std::size_t> count;
  for (const auto& path : system.paths) {
    const auto& instance = system.instances[path.instance];
    const auto place = instance.name + "/" + instance.locations[path.location];
    ofPaths.push_back(place + "/" + std::to_string(count[place]++));
  }
  std::vector<std::string> names;
  for (const auto& transition : system.transitions) {
    std::string name;
    for (auto part : transition.parts) name += ofPaths[part] + " ";
    names.push_back(std::move(name));
  }
  return names;
}

} // namespace proskill::verify
