#include "runtime/platform/ros.h"

#include "runtime/platform/ros_mapping.h"
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
  if (!file.contains("node")) return "proskill";
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

Json typesOf(const Json& file, Errors& errors) {
  for (const auto& [name, fields] : objectAt(file, "types"))
    errors.attempt([&] { checkFields(fields, "`types`: `" + name + "`"); });
  return file.contains("types") ? file["types"] : Json::object();
}

void addRos2(Json& made, const Json& file, const std::string& library, Errors& errors) {
  made["library"] = library;
  made["namespace"] =
      errors.attempt([&] { return file.contains("namespace") ? namespaceOf(file) : ""; });
  made["domain"] =
      errors.attempt([&] { return file.contains("domain") ? domainOf(file) : Json(); });
  made["types"] = errors.attempt([&] { return typesOf(file, errors); });
}

std::string pythonOf(const Json& file, Ros ros) {
  if (file.contains("python")) return wordAt(file, "python", "the platform");
  return ros == Ros::One ? "/usr/bin/python3" : "python3";
}

class RosReader {
public:
  RosReader(const analysis::Program& of, const codegen::PlatformInterface& with, Ros kind,
            Errors& by)
      : program(of), interface(with), ros(kind), errors(by) {}

  /// \return the mapping in terms of the adapter: positions of arguments, names of events
  /// \param elsewhere skills that need no action in the file
  Json platform(const Json& file, const std::string& library,
                const std::vector<std::string>& elsewhere) {
    std::vector<std::string> known{"kind",    "$schema",   "node",         "patience",
                                   "actions", "variables", "events",       "python",
                                   "startup", "restarts",  "restart_delay"};
    if (ros == Ros::Two) known.insert(known.end(), {"namespace", "domain", "types"});
    allowMembers(file, known, "the platform", errors);
    Json made{{"node", errors.attempt([&] { return nodeOf(file); })},
              {"patience", errors.attempt([&] { return patienceOf(file); })},
              {"actions", errors.attempt([&] { return actions(file, elsewhere); })},
              {"sensors", rosSensors(program, file, ros, errors)}};
    if (ros == Ros::Two) addRos2(made, file, library, errors);
    return made;
  }

private:
  static double patienceOf(const Json& file) {
    constexpr double kUsual = 5;
    return file.contains("patience") ? inSeconds(file["patience"], "patience") : kUsual;
  }

  Json actions(const Json& file, const std::vector<std::string>& elsewhere) {
    const auto& given = objectAt(file, "actions");
    Json made = Json::object();
    for (const auto& [skill, value] : given)
      errors.attempt(
          [&] { made[skill] = rosAction(program, performedNamed(skill), value, ros, errors); });
    for (const auto& performed : interface.performed)
      if (!given.contains(performed.skill) &&
          std::ranges::find(elsewhere, performed.skill) == elsewhere.end())
        errors.note({.why = "the platform file has no action for `" + performed.skill + "`",
                     .skill = performed.skill});
    for (const auto& skill : elsewhere) made.erase(skill);
    return made;
  }

  [[nodiscard]] const codegen::Performed& performedNamed(const std::string& name) const {
    const auto& all = interface.performed;
    const auto found = std::ranges::find(all, name, &codegen::Performed::skill);
    if (found != all.end()) return *found;
    std::vector<std::string> names;
    for (const auto& each : all) names.push_back(each.skill);
    throw unknown("basic skill", name, names);
  }

  const analysis::Program& program;
  const codegen::PlatformInterface& interface;
  Ros ros;
  Errors& errors;
};

/// The mapping with its actions in the order of the program, in which the adapter looks for them.
nlohmann::ordered_json inOrder(const Json& mapping, const codegen::PlatformInterface& interface) {
  nlohmann::ordered_json made = mapping;
  auto& actions = made["actions"] = nlohmann::ordered_json::object();
  for (const auto& performed : interface.performed)
    if (const auto found = mapping["actions"].find(performed.skill);
        found != mapping["actions"].end())
      actions[performed.skill] = *found;
  return made;
}

} // namespace

FileErrors readRosPlatform(const JsonFile& from, Ros ros, const analysis::Program& program,
                           const codegen::PlatformInterface& interface, ProcessSettings& settings,
                           const std::string& library) {
  return from.read([&](const Json& file, Errors& errors) {
    auto mapping =
        RosReader(program, interface, ros, errors).platform(file, library, settings.elsewhere);
    readLife(file, settings, errors);
    mapping["startup"] = static_cast<double>(settings.startup) / static_cast<double>(kSecond);
    settings.settings = inOrder(mapping, interface).dump();
    settings.command = {errors.attempt([&] { return pythonOf(file, ros); })};
  });
}

} // namespace proskill::runtime
