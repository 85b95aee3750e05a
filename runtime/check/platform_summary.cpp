#include "runtime/check/platform_summary.h"

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

std::string sentenceOf(PlatformKind kind, const Json& file) {
  switch (kind) {
  case PlatformKind::Simulated: return "The actions are simulated.";
  case PlatformKind::Process:
    return "The program " + code(joined(memberOf(file, "command"))) + " performs the actions.";
  case PlatformKind::Library:
    return "The library " + code(memberOf(file, "library")) + " performs the actions.";
  case PlatformKind::Ros1: return "An adapter to ROS 1 performs the actions.";
  case PlatformKind::Ros2: return "An adapter to ROS 2 performs the actions.";
  }
  return "";
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

std::string performerOf(PlatformKind kind, const std::string& skill, const Json& file) {
  const auto& action = memberOf(memberOf(file, "actions"), skill);
  switch (kind) {
  case PlatformKind::Simulated: return ofSimulation(action);
  case PlatformKind::Process: return "";
  case PlatformKind::Library: return ofLibrary(skill, memberOf(file, "functions"));
  case PlatformKind::Ros1:
  case PlatformKind::Ros2: return ofRos(action);
  }
  return "";
}

} // namespace

std::optional<PlatformSummary> platformSummary(std::string_view text,
                                               const analysis::Program& program) {
  const auto platform = PlatformFile::parse(text);
  if (!platform) return std::nullopt;
  const auto& file = platform->file.json();
  PlatformSummary summary{sentenceOf(platform->kind, file), {}};
  for (const auto& definition : program.skills.all) {
    const std::string skill(definition.name());
    if (definition->isComposite()) continue;
    if (auto performer = performerOf(platform->kind, skill, file); !performer.empty())
      summary.actions.emplace_back(skill, std::move(performer));
  }
  return summary;
}

} // namespace proskill::runtime
