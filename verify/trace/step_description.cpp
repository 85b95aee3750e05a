#include "verify/trace/step_description.h"

#include "verify/compile/watch.h"
#include "verify/state/evaluate.h"

#include <algorithm>
#include <numeric>

namespace proskill::verify {

std::string nameOf(const System& system, TransitionId transition, const StepLog& log) {
  const auto& parts = system.transitions[transition].parts;
  std::string name;
  for (std::size_t i = parts.size(); i-- > 0;) {
    const auto& instance = system.instances[system.paths[parts[i]].instance];
    if (!name.empty()) name += "_";
    name +=
        instance.name + (i < log.leaves.size() ? "_t" + std::to_string(log.leaves[i]) : "_error");
  }
  return name;
}

std::vector<std::string> instancesOf(const System& system, TransitionId transition) {
  std::vector<std::string> names;
  for (const auto part : system.transitions[transition].parts)
    names.push_back(system.instances[system.paths[part].instance].name);
  return names;
}

std::vector<fiacre::OriginId> mostDescriptiveLast(const fiacre::Provenance& provenance,
                                                  const StepLog& log) {
  std::vector<fiacre::OriginId> all;
  for (auto origin : log.origins)
    if (std::ranges::find(all, origin) == all.end()) all.push_back(origin);
  std::ranges::stable_partition(all, [&](fiacre::OriginId origin) {
    return origin >= provenance.origins.size() || provenance.origins[origin].description.empty();
  });
  return all;
}

std::vector<Change> valuesIn(const System& system, const std::vector<Word>& state) {
  std::vector<Change> all;
  for (const auto& watched : system.watched)
    all.push_back(
        {watched.display, {}, shown(watched, readCell(system, watched.cell, state.data()))});
  return all;
}

std::vector<Change> changesBetween(const System& system, const std::vector<std::uint32_t>& which,
                                   const std::vector<Word>& before,
                                   const std::vector<Word>& after) {
  std::vector<Change> all;
  for (auto i : which) {
    const auto& watched = system.watched[i];
    const auto old = readCell(system, watched.cell, before.data());
    const auto now = readCell(system, watched.cell, after.data());
    if (old != now) all.push_back({watched.display, shown(watched, old), shown(watched, now)});
  }
  return all;
}

std::vector<Change> changesBetween(const System& system, const std::vector<Word>& before,
                                   const std::vector<Word>& after) {
  std::vector<std::uint32_t> all(system.watched.size());
  std::iota(all.begin(), all.end(), 0U);
  return changesBetween(system, all, before, after);
}

} // namespace proskill::verify
