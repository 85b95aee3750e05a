#include "viz/pictures.h"

#include "viz/builder.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::viz {
namespace {

std::expected<Graph, std::string> drawNamedBody(const analysis::Program& program,
                                                const std::string& name) {
  if (const auto* skill = program.skills.find(name)) {
    if (skill->node().body) return drawBody(program, *skill);
    return std::unexpected(fmt::format("the skill `{}` is basic and has no body", name));
  }
  if (const auto* environment = program.environments.find(name))
    return drawEnvironment(program, *environment);
  return std::unexpected(fmt::format("there is no skill or environment `{}`", name));
}

} // namespace

std::string_view wordOf(Kind kind) {
  return std::ranges::find(kKindWords, kind, [](const auto& entry) { return entry.second; })->first;
}

std::optional<Kind> kindOf(std::string_view word) {
  for (const auto& [known, kind] : kKindWords)
    if (known == word) return kind;
  return std::nullopt;
}

std::expected<Graph, std::string> draw(const analysis::Program& program, const Request& request) {
  const auto& name = request.name;
  switch (request.kind) {
  case Kind::StateVariable:
    if (const auto* variable = program.stateVariables.find(name))
      return drawStateVariable(program, *variable, request.forbidden);
    return std::unexpected(fmt::format("there is no state variable `{}`", name));
  case Kind::Event:
    if (const auto* event = program.events.find(name)) return drawEvent(program, *event);
    return std::unexpected(fmt::format("there is no event `{}`", name));
  case Kind::Skill:
    if (const auto* skill = program.skills.find(name))
      return skill->node().body ? drawBody(program, *skill) : drawBasicSkill(program, *skill);
    return std::unexpected(fmt::format("there is no skill `{}`", name));
  case Kind::Body: return drawNamedBody(program, name);
  case Kind::Calls: break;
  }
  return drawCalls(program);
}

std::vector<Request> allPictures(const analysis::Program& program, Kind kind) {
  std::vector<Request> found;
  const auto add = [&](std::string_view name) {
    if (!name.empty()) found.push_back({kind, std::string(name), false});
  };
  switch (kind) {
  case Kind::StateVariable:
    for (const auto& each : program.stateVariables.all) add(each.name());
    break;
  case Kind::Event:
    for (const auto& each : program.events.all)
      if (hasTimesOfItsOwn(each)) add(each.name());
    break;
  case Kind::Skill:
    for (const auto& each : program.skills.all)
      if (!each->body) add(each.name());
    break;
  case Kind::Body:
    for (const auto& each : program.skills.all)
      if (each->body) add(each.name());
    for (const auto& each : program.environments.all) add(each.name());
    break;
  case Kind::Calls: found.push_back({}); break;
  }
  return found;
}

std::vector<Request> allPictures(const analysis::Program& program) {
  std::vector<Request> found;
  for (auto kind : {Kind::StateVariable, Kind::Event, Kind::Skill, Kind::Body, Kind::Calls})
    for (auto& request : allPictures(program, kind)) found.push_back(std::move(request));
  return found;
}

} // namespace proskill::viz
