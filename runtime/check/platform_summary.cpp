#include "runtime/check/platform_summary.h"

#include "runtime/platform/json.h"
#include "runtime/platform/settings.h"

namespace proskill::runtime {

namespace {

/// A word of the file as code, without characters that would end the code or the line.
std::string code(const Json& value) {
  auto text = value.is_string() ? value.get<std::string>() : value.dump();
  std::erase_if(text, [](unsigned char c) { return c == '`' || c < ' '; });
  return "`" + text + "`";
}

/// null if the value has no such member
const Json& memberOf(const Json& value, const std::string& name) {
  static const Json kNone;
  return value.is_object() && value.contains(name) ? value[name] : kNone;
}

std::string joined(const Json& words) {
  std::string all;
  for (const auto& word : words)
    if (word.is_string()) all += (all.empty() ? "" : " ") + word.get<std::string>();
  return all;
}

std::string sentenceOf(const std::string& kind, const Json& file) {
  if (kind == "process")
    return "The program " + code(joined(memberOf(file, "command"))) + " performs the actions.";
  if (kind == "library")
    return "The library " + code(memberOf(file, "library")) + " performs the actions.";
  if (kind == "ros1") return "An adapter to ROS 1 performs the actions.";
  if (kind == "ros2") return "An adapter to ROS 2 performs the actions.";
  return "The actions are simulated.";
}

std::string ofRos(const Json& action) {
  for (const auto* word : {"action", "service", "topic"})
    if (const auto& name = memberOf(action, word); name.is_string())
      return std::string(word) + " " + code(name);
  return "";
}

std::string ofLibrary(const std::string& skill, const Json& functions) {
  const auto& other = memberOf(functions, skill);
  if (other.is_string()) return "function " + code(other);
  return "function `skill_" + skill + "` or `begin_" + skill + "`";
}

std::string ofSimulation(const Json& action) {
  const auto& duration = memberOf(action, "duration");
  return duration.is_null() ? "" : "takes " + code(duration) + " s";
}

std::string performerOf(const std::string& kind, const std::string& skill, const Json& file) {
  if (kind == "process") return "";
  if (kind == "library") return ofLibrary(skill, memberOf(file, "functions"));
  const auto& action = memberOf(memberOf(file, "actions"), skill);
  return kind == "simulated" ? ofSimulation(action) : ofRos(action);
}

} // namespace

std::optional<PlatformSummary> platformSummary(std::string_view text,
                                               const analysis::Program& program) {
  const auto kind = platformKind(text);
  if (!kind) return std::nullopt;
  const auto file = parsedText(text);
  PlatformSummary summary{sentenceOf(*kind, file), {}};
  for (const auto& definition : program.skills.all) {
    const std::string skill(definition.name());
    if (definition->isComposite()) continue;
    if (auto performer = performerOf(*kind, skill, file); !performer.empty())
      summary.actions.emplace_back(skill, std::move(performer));
  }
  return summary;
}

} // namespace proskill::runtime
