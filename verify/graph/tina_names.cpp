#include "verify/graph/tina_names.h"

#include <algorithm>

namespace proskill::verify {

namespace {

/// `skill_takeoff_1` as `skill__takeoff_1`: the number after the last `_` is kept separate.
std::string numbered(std::string_view name) {
  const auto last = name.rfind('_');
  return doubled(name.substr(0, last)) + std::string(name.substr(last));
}

/// `skill[0].status` in the notation of frac's C code: `skill.at[0].status`.
std::string accessed(std::string_view path) {
  std::string made;
  for (const char c : path) {
    if (c == '[') made += ".at";
    made += c;
  }
  return made;
}

/// `a` and `[0].b` of `a[0].b`.
std::pair<std::string_view, std::string_view> split(std::string_view path) {
  const auto end = std::min(path.find_first_of("[."), path.size());
  return {path.substr(0, end), path.substr(end)};
}

} // namespace

std::string doubled(std::string_view name) {
  std::string made;
  for (const char c : name) made += c == '_' ? "__" : std::string(1, c);
  return made;
}

std::string tinaInstance(const System& system, InstanceId instance) {
  return numbered(system.instances[instance].name);
}

std::string tinaPlace(const System& system, InstanceId instance, std::uint32_t location) {
  return tinaInstance(system, instance) + "_s" +
         doubled(system.instances[instance].locations[location]);
}

std::string tinaVariable(const System& system, CellId cell, std::string_view main) {
  std::string_view name = system.cells[cell].name;
  constexpr std::string_view kLength = "length of "; // of a queue
  const bool length = name.starts_with(kLength);
  if (length) name.remove_prefix(kLength.size());
  std::string owner = doubled(main) + "_1";
  // variables of the main component come first
  if (!system.instances.empty() && cell > system.instances.front().location) {
    const auto dot = name.find('.');
    if (dot != std::string_view::npos) {
      owner = numbered(name.substr(0, dot));
      name.remove_prefix(dot + 1);
    }
  }
  const auto [variable, parts] = split(name);
  std::string made = owner + "_v" + doubled(variable) + accessed(parts);
  if (length) made += ".length";
  return made.find_first_of(".[") == std::string::npos ? made : "{" + made + "}";
}

std::string tinaTransition(const System& system, TransitionId transition, const StepLog& log) {
  const auto& parts = system.transitions[transition].parts;
  std::string name;
  for (std::size_t i = parts.size(); i-- > 0;) {
    if (!name.empty()) name += "_";
    name += tinaInstance(system, system.paths[parts[i]].instance) + "_t" +
            std::to_string(log.leaves.at(i));
  }
  return name;
}

} // namespace proskill::verify
