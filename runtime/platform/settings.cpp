#include "runtime/platform/settings.h"

#include "runtime/platform/messages.h"

#include <algorithm>

namespace proskill::runtime {

namespace {

class Reader {
public:
  Reader(const codegen::PlatformInterface& of, SimulationSettings& to, Errors& by)
      : interface(of), settings(to), errors(by) {}

  void platform(const Json& file) {
    allowMembers(file, {"kind", "$schema", "actions", "events", "interrupts"}, "the platform",
                 errors);
    eachMember(file, "actions", [&](const auto& name, const auto& value) { action(name, value); });
    for (const bool interrupts : {false, true})
      eachMember(file, interrupts ? "interrupts" : "events",
                 [&](const auto& name, const auto& value) {
                   every(signal(name, interrupts), name, value);
                 });
  }

  void script(const Json& file) {
    allowMembers(file, {"$schema", "actions", "signals"}, "the script", errors);
    eachMember(file, "actions", [&](const auto& name, const auto& value) { runs(name, value); });
    if (file.contains("signals")) {
      // with a script, nothing else happens
      std::ranges::fill(settings.signals, std::nullopt);
      errors.attempt([&] {
        for (const auto& said : listOf(file["signals"], "signals"))
          errors.attempt([&] { settings.script.push_back(saidOf(said)); });
      });
    }
    std::ranges::stable_sort(settings.script, {}, &SimulationSettings::Said::date);
  }

private:
  /// Reads the members of an optional object.
  template <class Call> void eachMember(const Json& file, const char* key, Call&& call) {
    errors.attempt([&] {
      for (const auto& [name, value] : objectAt(file, key))
        errors.attempt([&] { call(name, value); });
    });
  }

  [[nodiscard]] std::uint32_t actionNamed(const std::string& name) const {
    const auto& all = interface.performed;
    const auto found = std::ranges::find(all, name, &codegen::Performed::skill);
    if (found == all.end()) {
      std::vector<std::string> names;
      for (const auto& each : all) names.push_back(each.skill);
      throw unknown("basic skill", name, names);
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
    throw unknown(interrupts ? "skill with `:interrupt`" : "event", name, names);
  }

  [[nodiscard]] std::uint32_t resultNamed(std::uint32_t action, const std::string& name) const {
    const auto& all = interface.performed[action].results;
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (resultName(all[i]) == name) return i;
      names.push_back(resultName(all[i]));
    }
    throw unknown("result of `" + interface.performed[action].skill + "`", name, names);
  }

  void action(const std::string& name, const Json& value) {
    const auto index = actionNamed(name);
    auto& action = settings.actions[index];
    allowMembers(value, {"duration", "stops", "results"}, "`" + name + "`", errors);
    errors.attempt([&] {
      if (value.contains("duration"))
        action.duration = spanOf(value["duration"], name + ".duration");
    });
    errors.attempt([&] {
      if (value.contains("stops")) action.stops = spanOf(value["stops"], name + ".stops");
    });
    if (value.contains("results")) weights(index, value);
  }

  void weights(std::uint32_t index, const Json& value) {
    auto& weights = settings.actions[index].weights;
    std::ranges::fill(weights, 0U);
    const auto before = errors.all().size();
    unsigned sum = 0;
    eachMember(value, "results", [&](const auto& result, const auto& weight) {
      sum += weights[resultNamed(index, result)] = weightOf(result, weight);
    });
    if (sum == 0 && errors.all().size() == before)
      throw Wrong{"no result of `" + interface.performed[index].skill + "` has a weight",
                  &value["results"]};
  }

  static unsigned weightOf(const std::string& result, const Json& weight) {
    if (weight.is_number_unsigned() && weight.get<std::uint64_t>() <= 1'000'000)
      return weight.get<unsigned>();
    throw Wrong{"the weight of `" + result + "` must be a natural number up to a million", &weight};
  }

  void runs(const std::string& name, const Json& value) {
    auto& endings = settings.endings[actionNamed(name)];
    for (const auto& ending : listOf(value, name))
      errors.attempt([&] { endings.push_back(endingOf(name, ending)); });
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
    allowMembers(value, {"result", "after"}, "a run of `" + name + "`", errors);
    SimulationSettings::Ending ending;
    if (value.contains("after")) ending.after = secondsOf(value["after"], name + ".after");
    if (value.contains("result")) {
      ending.result = resultNamed(actionNamed(name), stringAt(value, "result"));
    }
    return ending;
  }

  [[nodiscard]] SimulationSettings::Said saidOf(const Json& value) const {
    allowMembers(value, {"at", "event", "interrupt"}, "a signal", errors);
    const bool interrupts = value.contains("interrupt");
    const std::string key = interrupts ? "interrupt" : "event";
    if (!value.contains("at") || !value.contains(key) || !value[key].is_string())
      throw Wrong{"a signal must have `at` and either `event` or `interrupt`", &value};
    return {secondsOf(value["at"], "at"), signal(stringAt(value, key), interrupts)};
  }

  const codegen::PlatformInterface& interface;
  SimulationSettings& settings;
  Errors& errors;
};

std::vector<std::string> commandOf(const Json& file) {
  if (!file.contains("command")) throw Wrong{"`command` is missing: the program and its arguments"};
  std::vector<std::string> command;
  for (const auto& word : listOf(file["command"], "command")) {
    if (!word.is_string()) throw Wrong{"`command` must be a list of strings", &word};
    command.push_back(word.get<std::string>());
  }
  if (command.empty() || command.front().empty())
    throw Wrong{"`command` must begin with a program", &file["command"]};
  return command;
}

std::string libraryOf(const Json& file) {
  if (!file.contains("library")) throw Wrong{"`library` is missing: the file of a shared library"};
  const auto& library = stringAt(file, "library");
  if (library.empty())
    throw Wrong{"`library` must be the file of a shared library", &file["library"]};
  return library;
}

std::map<std::string, std::string>
functionsOf(const Json& file, const codegen::PlatformInterface& interface, Errors& errors) {
  std::vector<std::string> skills;
  for (const auto& performed : interface.performed) skills.push_back(performed.skill);
  std::map<std::string, std::string> functions;
  for (const auto& [skill, function] : objectAt(file, "functions")) {
    if (std::ranges::find(skills, skill) == skills.end())
      errors.note(unknown("basic skill", skill, skills));
    else if (!function.is_string() || function.get_ref<const std::string&>().empty())
      errors.note({"the function of `" + skill + "` must be a name", &function});
    else
      functions[skill] = function.get<std::string>();
  }
  return functions;
}

unsigned restartsOf(const Json& file) {
  if (!file.contains("restarts")) return 0;
  const auto& restarts = file["restarts"];
  if (!restarts.is_number_unsigned() || restarts.get<std::uint64_t>() > 1'000'000)
    throw Wrong{"`restarts` must be a natural number up to a million", &restarts};
  return restarts.get<unsigned>();
}

/// Simulated, unless the file has what another kind needs: then its kind was forgotten.
PlatformKind unnamedKind(const Json& file) {
  for (const auto& [member, kind] : {std::pair("command", "process"), {"library", "library"}})
    if (const auto found = file.find(member); found != file.end())
      throw Wrong{
          fmt::format("`\"kind\": \"{}\"` is missing: a simulation has no `{}`", kind, member),
          &*found};
  return PlatformKind::Simulated;
}

PlatformKind kindOf(const Json& file) {
  static const std::map<std::string, PlatformKind, std::less<>> kinds{
      {"simulated", PlatformKind::Simulated},
      {"process", PlatformKind::Process},
      {"library", PlatformKind::Library},
      {"ros1", PlatformKind::Ros1},
      {"ros2", PlatformKind::Ros2}};
  if (!file.contains("kind")) return unnamedKind(file);
  const auto& named = stringAt(file, "kind");
  if (const auto found = kinds.find(named); found != kinds.end()) return found->second;
  throw Wrong{"`kind` must be `simulated`, `process`, `library`, `ros1` or `ros2`, not `" + named +
                  "`",
              &named};
}

} // namespace

void readLife(const Json& file, ProcessSettings& settings, Errors& errors) {
  errors.attempt([&] {
    if (file.contains("startup")) settings.startup = secondsOf(file["startup"], "startup");
    if (settings.startup == 0) throw Wrong{"`startup` must be more than 0 s", &file["startup"]};
  });
  errors.attempt([&] {
    if (file.contains("restart_delay"))
      settings.restartDelay = secondsOf(file["restart_delay"], "restart_delay");
  });
  settings.restarts = errors.attempt([&] { return restartsOf(file); });
}

std::expected<PlatformFile, FileErrors> PlatformFile::parse(std::string_view text) {
  auto parsed = JsonFile::parse(text);
  if (!parsed) return std::unexpected(std::move(parsed.error()));
  PlatformFile made{std::move(*parsed)};
  auto errors = made.file.read([&](const Json& file, Errors&) { made.kind = kindOf(file); });
  if (!errors.empty()) return std::unexpected(std::move(errors));
  return made;
}

FileErrors readSimulation(const JsonFile& from, const codegen::PlatformInterface& interface,
                          SimulationSettings& settings) {
  return from.read([&](const Json& file, Errors& errors) {
    Reader(interface, settings, errors).platform(file);
  });
}

FileErrors readScript(const JsonFile& from, const codegen::PlatformInterface& interface,
                      SimulationSettings& settings) {
  return from.read(
      [&](const Json& file, Errors& errors) { Reader(interface, settings, errors).script(file); });
}

FileErrors readProcessPlatform(const JsonFile& from, ProcessSettings& settings) {
  return from.read([&](const Json& file, Errors& errors) {
    allowMembers(file, {"kind", "$schema", "command", "startup", "restarts", "restart_delay"},
                 "the platform", errors);
    settings.command = errors.attempt([&] { return commandOf(file); });
    readLife(file, settings, errors);
  });
}

FileErrors readLibraryPlatform(const JsonFile& from, const codegen::PlatformInterface& interface,
                               LibrarySettings& settings) {
  return from.read([&](const Json& file, Errors& errors) {
    allowMembers(
        file, {"kind", "$schema", "library", "functions", "startup", "restarts", "restart_delay"},
        "the platform", errors);
    settings.library = errors.attempt([&] { return libraryOf(file); });
    if (!settings.library.empty()) settings.place = from.placeOf(&file["library"]);
    settings.functions = errors.attempt([&] { return functionsOf(file, interface, errors); });
    readLife(file, settings.process, errors);
  });
}

bool speaksForEnvironment(const JsonFile& file) {
  const auto& object = file.json();
  return object.contains("signals") || object.contains("events") || object.contains("interrupts");
}

} // namespace proskill::runtime
