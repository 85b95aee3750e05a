#include "report/run/run_places.h"

#include "report/report_json.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <algorithm>

namespace proskill::report {

namespace {

using Places = std::vector<OrderedJson>; ///< by location of a process

OrderedJson placeOf(RunSubject subject, fiacre::OriginId id) {
  const auto& origin = subject.executable.model.provenance.origins[id];
  return locationJson(subject.program, {origin.file, {origin.begin, origin.end}});
}

/// The locations of a body at its statements; the others have the whole body as their origin.
Places statements(RunSubject subject, const verify::Instance& instance) {
  Places places;
  for (const auto id : instance.locationOrigins)
    places.push_back(id == 0 || id == instance.origin ? OrderedJson() : placeOf(subject, id));
  return places;
}

/// All locations of a basic skill that runs.
Places ofAction(RunSubject subject, const verify::Instance& instance, const runtime::Action& action,
                const std::string& skill) {
  Places places(instance.locations.size());
  const auto* definition = subject.program.skills.find(skill);
  if (!definition) return places;
  const auto& node = definition->node();
  const auto range = node.action ? node.action->range : node.name.range;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (static_cast<std::int64_t>(i) != action.idle)
      places[i] = locationJson(subject.program, {definition->file, range});
  return places;
}

bool isAnywhere(const Places& places) {
  return std::ranges::any_of(places, [](const auto& place) { return !place.is_null(); });
}

} // namespace

RunPlaces::RunPlaces(RunSubject subject) : system(subject.executable.system) {
  const auto& executable = subject.executable;
  const auto start = verify::initialState(system);
  for (verify::InstanceId id = 0; id < system.instances.size(); ++id) {
    const auto& instance = system.instances[id];
    const auto action = std::ranges::find(executable.actions, id, &runtime::Action::instance);
    const bool performs = action != executable.actions.end();
    const auto index = static_cast<std::size_t>(action - executable.actions.begin());
    const auto& actor = performs ? executable.model.performed[index].skill
                                 : executable.model.provenance.origins[instance.origin].actor;
    auto places =
        performs ? ofAction(subject, instance, *action, actor) : statements(subject, instance);
    if (!isAnywhere(places)) continue;
    cells.push_back(instance.location);
    table.push_back({{"actor", actor},
                     {"performs", performs},
                     {"start", verify::readCell(system, instance.location, start.data())},
                     {"places", std::move(places)}});
  }
}

void RunPlaces::addMoves(std::string& to, const std::vector<verify::Word>& before,
                         const std::vector<verify::Word>& after) const {
  to += '[';
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto now = verify::readCell(system, cells[i], after.data());
    if (verify::readCell(system, cells[i], before.data()) == now) continue;
    if (to.back() == ']') to += ',';
    to += '[';
    to += std::to_string(i);
    to += ',';
    to += std::to_string(now);
    to += ']';
  }
  to += ']';
}

} // namespace proskill::report
