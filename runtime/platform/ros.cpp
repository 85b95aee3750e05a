#include "runtime/platform/ros.h"

#include "runtime/platform/json_place.h"
#include "runtime/platform/ros_actions.h"
#include "runtime/platform/ros_sensors.h"
#include "runtime/platform/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace proskill::runtime {

namespace {

/// The greatest number that leaves room for the ports of a domain.
constexpr int kDomains = 232;

bool isLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string nodeOf(const Json& file) {
  const auto& node = wordAt(file, "node", "the platform");
  if (!std::ranges::all_of(node, isLetter) || std::isdigit(static_cast<unsigned char>(node[0])))
    throw Wrong{"`node` must be a name of letters, digits and _", &node};
  return node;
}

std::string namespaceOf(const Json& file) {
  const auto& name = stringAt(file, "namespace");
  if (!std::ranges::all_of(name, [](char c) { return isLetter(c) || c == '/'; }))
    throw Wrong{"`namespace` must have names of letters, digits and _, separated by /", &name};
  return name;
}

Json domainOf(const Json& file) {
  const auto& domain = file["domain"];
  if (!domain.is_number_integer() || domain < 0 || domain > kDomains)
    throw Wrong{"`domain` must be a natural number up to " + std::to_string(kDomains), &domain};
  return domain;
}

/// The fields of messages: what they mean, the adapter knows.
void checkFields(const Json& fields, const std::string& of) {
  if (!fields.is_object()) throw Wrong{of + " must be an object", &fields};
  for (const auto& [name, type] : fields.items()) {
    if (type.is_object())
      checkFields(type, fmt::format("{}.{}", of, name));
    else if (!type.is_string() || type.get_ref<const std::string&>().empty())
      throw Wrong{fmt::format("{}: the type of `{}` must be a string", of, name), &type};
  }
}

Json typesOf(const Json& file) {
  for (const auto& [name, fields] : objectAt(file, "types"))
    checkFields(fields, "`types`: `" + name + "`");
  return file.contains("types") ? file["types"] : Json::object();
}

void addRos2(Json& made, const Json& file, const std::string& library) {
  made["library"] = library;
  made["namespace"] = file.contains("namespace") ? namespaceOf(file) : "";
  made["domain"] = file.contains("domain") ? domainOf(file) : Json();
  made["types"] = typesOf(file);
}

class RosReader {
public:
  RosReader(const analysis::Program& of, const codegen::PlatformInterface& with, Ros kind)
      : program(of), interface(with), ros(kind) {}

  /// \return the mapping in terms of the adapter: positions of arguments, names of events
  Json platform(const Json& file, const std::string& library) {
    std::vector<std::string> known{"kind",    "$schema",   "node",         "patience",
                                   "actions", "variables", "events",       "python",
                                   "startup", "restarts",  "restart_delay"};
    if (ros == Ros::Two) known.insert(known.end(), {"namespace", "domain", "types"});
    allowMembers(file, known, "the platform");
    Json made{{"node", "proskill"}, {"patience", 5.0}, {"actions", Json::object()}};
    if (file.contains("node")) made["node"] = nodeOf(file);
    if (file.contains("patience")) made["patience"] = inSeconds(file["patience"], "patience");
    if (ros == Ros::Two) addRos2(made, file, library);
    for (const auto& [skill, value] : objectAt(file, "actions"))
      made["actions"][skill] = rosAction(program, performedNamed(skill), value, ros);
    for (const auto& performed : interface.performed)
      if (!made["actions"].contains(performed.skill))
        throw WrongSkill{"the platform file has no action for `" + performed.skill + "`",
                         performed.skill};
    made["sensors"] = rosSensors(program, file, ros);
    return made;
  }

private:
  [[nodiscard]] const codegen::Performed& performedNamed(const std::string& name) const {
    const auto& all = interface.performed;
    const auto found = std::ranges::find(all, name, &codegen::Performed::skill);
    if (found != all.end()) return *found;
    std::vector<std::string> names;
    for (const auto& each : all) names.push_back(each.skill);
    throwUnknown("basic skill", name, names);
  }

  const analysis::Program& program;
  const codegen::PlatformInterface& interface;
  Ros ros;
};

} // namespace

std::optional<FileError> readRosPlatform(std::string_view text, Ros ros,
                                         const analysis::Program& program,
                                         const codegen::PlatformInterface& interface,
                                         ProcessSettings& settings, const std::string& library) {
  const auto read = [&](const Json& file) {
    auto mapping = RosReader(program, interface, ros).platform(file, library);
    readLife(file, settings);
    mapping["startup"] = static_cast<double>(settings.startup) / static_cast<double>(kSecond);
    settings.settings = mapping.dump();
    const auto* usual = ros == Ros::One ? "/usr/bin/python3" : "python3";
    settings.command = {file.contains("python") ? wordAt(file, "python", "the platform") : usual};
  };
  try {
    return readFile(text, read);
  } catch (const WrongSkill& wrong) {
    return FileError{wrong.why, {}, wrong.skill};
  }
}

} // namespace proskill::runtime
