#include "runtime/platform/settings.h"

#include "runtime/platform/json_place.h"
#include "runtime/platform/messages.h"

#include <algorithm>

namespace proskill::runtime {

namespace {

class Reader {
public:
  Reader(const codegen::PlatformInterface& of, SimulationSettings& to)
      : interface(of), settings(to) {}

  void platform(const Json& file) {
    allowMembers(file, {"kind", "$schema", "actions", "events", "interrupts"}, "the platform");
    for (const auto& [name, value] : objectAt(file, "actions")) action(name, value);
    for (const auto& [name, value] : objectAt(file, "events"))
      every(signal(name, false), name, value);
    for (const auto& [name, value] : objectAt(file, "interrupts"))
      every(signal(name, true), name, value);
  }

  void script(const Json& file) {
    allowMembers(file, {"$schema", "actions", "signals"}, "the script");
    for (const auto& [name, value] : objectAt(file, "actions")) {
      auto& endings = settings.endings[actionNamed(name)];
      for (const auto& ending : listOf(value, name)) endings.push_back(endingOf(name, ending));
    }
    if (file.contains("signals")) {
      // with a script, nothing else happens
      std::ranges::fill(settings.signals, std::nullopt);
      for (const auto& said : listOf(file["signals"], "signals"))
        settings.script.push_back(saidOf(said));
    }
    std::ranges::stable_sort(settings.script, {}, &SimulationSettings::Said::date);
  }

private:
  [[nodiscard]] std::uint32_t actionNamed(const std::string& name) const {
    const auto& all = interface.performed;
    const auto found = std::ranges::find(all, name, &codegen::Performed::skill);
    if (found == all.end()) {
      std::vector<std::string> names;
      for (const auto& each : all) names.push_back(each.skill);
      throwUnknown("basic skill", name, names);
    }
    return static_cast<std::uint32_t>(found - all.begin());
  }

  [[nodiscard]] std::uint32_t signal(const std::string& name, bool interrupts) const {
    const auto& all = interface.signals;
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (all[i].interrupts != interrupts) continue;
      if (all[i].name == name) return i;
      names.push_back(all[i].name);
    }
    throwUnknown(interrupts ? "skill with `:interrupt`" : "event", name, names);
  }

  [[nodiscard]] std::uint32_t resultNamed(std::uint32_t action, const std::string& name) const {
    const auto& all = interface.performed[action].results;
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (resultName(all[i]) == name) return i;
      names.push_back(resultName(all[i]));
    }
    throwUnknown("result of `" + interface.performed[action].skill + "`", name, names);
  }

  void action(const std::string& name, const Json& value) {
    const auto index = actionNamed(name);
    auto& action = settings.actions[index];
    allowMembers(value, {"duration", "stops", "results"}, "`" + name + "`");
    if (value.contains("duration")) action.duration = spanOf(value["duration"], name + ".duration");
    if (value.contains("stops")) action.stops = spanOf(value["stops"], name + ".stops");
    if (!value.contains("results")) return;
    std::ranges::fill(action.weights, 0U);
    unsigned sum = 0;
    for (const auto& [result, weight] : objectAt(value, "results")) {
      if (!weight.is_number_unsigned() || weight.get<std::uint64_t>() > 1'000'000)
        throw Wrong{"the weight of `" + result + "` must be a natural number up to a million",
                    &weight};
      sum += action.weights[resultNamed(index, result)] = weight.get<unsigned>();
    }
    if (sum == 0) throw Wrong{"no result of `" + name + "` has a weight", &value["results"]};
  }

  void every(std::uint32_t index, const std::string& name, const Json& value) {
    if (value.is_null()) {
      settings.signals[index].reset();
      return;
    }
    settings.signals[index] = spanOf(value, name);
    if (settings.signals[index]->first == 0)
      throw Wrong{"`" + name + "` may come again at once: let some time pass", &value};
  }

  [[nodiscard]] SimulationSettings::Ending endingOf(const std::string& name,
                                                    const Json& value) const {
    allowMembers(value, {"result", "after"}, "a run of `" + name + "`");
    SimulationSettings::Ending ending;
    if (value.contains("after")) ending.after = secondsOf(value["after"], name + ".after");
    if (value.contains("result")) {
      ending.result = resultNamed(actionNamed(name), stringAt(value, "result"));
    }
    return ending;
  }

  [[nodiscard]] SimulationSettings::Said saidOf(const Json& value) const {
    allowMembers(value, {"at", "event", "interrupt"}, "a signal");
    const bool interrupts = value.contains("interrupt");
    const std::string key = interrupts ? "interrupt" : "event";
    if (!value.contains("at") || !value.contains(key) || !value[key].is_string())
      throw Wrong{"a signal must have `at` and either `event` or `interrupt`", &value};
    return {secondsOf(value["at"], "at"), signal(stringAt(value, key), interrupts)};
  }

  const codegen::PlatformInterface& interface;
  SimulationSettings& settings;
};

void processSettings(const Json& file, ProcessSettings& settings) {
  allowMembers(file, {"kind", "$schema", "command", "startup", "restarts", "restart_delay"},
               "the platform");
  if (!file.contains("command")) throw Wrong{"`command` is missing: the program and its arguments"};
  for (const auto& word : listOf(file["command"], "command")) {
    if (!word.is_string()) throw Wrong{"`command` must be a list of strings", &word};
    settings.command.push_back(word.get<std::string>());
  }
  if (settings.command.empty() || settings.command.front().empty())
    throw Wrong{"`command` must begin with a program", &file["command"]};
  readLife(file, settings);
}

void librarySettings(const Json& file, const codegen::PlatformInterface& interface,
                     LibrarySettings& settings) {
  allowMembers(file,
               {"kind", "$schema", "library", "functions", "startup", "restarts", "restart_delay"},
               "the platform");
  if (!file.contains("library")) throw Wrong{"`library` is missing: the file of a shared library"};
  settings.library = stringAt(file, "library");
  if (settings.library.empty())
    throw Wrong{"`library` must be the file of a shared library", &file["library"]};
  std::vector<std::string> skills;
  for (const auto& performed : interface.performed) skills.push_back(performed.skill);
  for (const auto& [skill, function] : objectAt(file, "functions")) {
    if (std::ranges::find(skills, skill) == skills.end())
      throwUnknown("basic skill", skill, skills);
    if (!function.is_string() || function.get_ref<const std::string&>().empty())
      throw Wrong{"the function of `" + skill + "` must be a name", &function};
    settings.functions[skill] = function.get<std::string>();
  }
  readLife(file, settings.process);
}

} // namespace

void readLife(const Json& file, ProcessSettings& settings) {
  if (file.contains("startup")) settings.startup = secondsOf(file["startup"], "startup");
  if (settings.startup == 0) throw Wrong{"`startup` must be more than 0 s", &file["startup"]};
  if (file.contains("restart_delay"))
    settings.restartDelay = secondsOf(file["restart_delay"], "restart_delay");
  if (!file.contains("restarts")) return;
  const auto& restarts = file["restarts"];
  if (!restarts.is_number_unsigned() || restarts.get<std::uint64_t>() > 1'000'000)
    throw Wrong{"`restarts` must be a natural number up to a million", &restarts};
  settings.restarts = restarts.get<unsigned>();
}

std::optional<FileError> readPlatform(std::string_view text,
                                      const codegen::PlatformInterface& interface,
                                      SimulationSettings& settings) {
  return readFile(text, [&](const Json& file) { Reader(interface, settings).platform(file); });
}

std::optional<FileError> readScript(std::string_view text,
                                    const codegen::PlatformInterface& interface,
                                    SimulationSettings& settings) {
  return readFile(text, [&](const Json& file) { Reader(interface, settings).script(file); });
}

std::optional<FileError> readProcessPlatform(std::string_view text, ProcessSettings& settings) {
  return readFile(text, [&](const Json& file) { processSettings(file, settings); });
}

std::optional<FileError> readLibraryPlatform(std::string_view text,
                                             const codegen::PlatformInterface& interface,
                                             LibrarySettings& settings) {
  return readFile(text, [&](const Json& file) {
    librarySettings(file, interface, settings);
    settings.place = placeOfPart(text, file, &file["library"]);
  });
}

bool speaksForEnvironment(std::string_view text) {
  const auto value = parsedText(text);
  return value.is_object() &&
         (value.contains("signals") || value.contains("events") || value.contains("interrupts"));
}

std::expected<std::string, FileError> platformKind(std::string_view text) {
  std::string kind = "simulated";
  const std::vector<std::string> known{"simulated", "process", "library", "ros1", "ros2"};
  auto wrong = readFile(text, [&](const Json& file) {
    if (!file.contains("kind")) return;
    const auto& named = stringAt(file, "kind");
    if (std::ranges::find(known, named) == known.end())
      throw Wrong{"`kind` must be `simulated`, `process`, `library`, `ros1` or `ros2`, not `" +
                      named + "`",
                  &named};
    kind = named;
  });
  if (wrong) return std::unexpected(std::move(*wrong));
  return kind;
}

} // namespace proskill::runtime
