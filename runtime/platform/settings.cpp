#include "runtime/platform/settings.h"

#include "syntax/diagnostics/suggest.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace proskill::runtime {

namespace {

using Json = nlohmann::json;

/// What is wrong with a file.
struct Wrong {
  std::string why;
};

/// Where a byte is, as people count: both from 1.
std::string placeOf(std::string_view text, std::size_t byte) {
  const auto before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const auto line = std::ranges::count(before, '\n') + 1;
  const auto column = before.size() - (before.rfind('\n') + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

Json parsed(std::string_view text) {
  Json value;
  try {
    value = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw Wrong{"it is not JSON at " + placeOf(text, error.byte)};
  }
  if (!value.is_object()) throw Wrong{"it is not an object"};
  return value;
}

Nanoseconds seconds(const Json& value, const std::string& of) {
  if (!value.is_number()) throw Wrong{"`" + of + "` is no number of seconds"};
  const auto number = value.get<double>();
  if (!(number >= 0 && number <= 1e9)) throw Wrong{"`" + of + "` is not between 0 and 1e9 s"};
  return std::llround(number * static_cast<double>(kSecond));
}

Span span(const Json& value, const std::string& of) {
  if (!value.is_array() || value.size() != 2) throw Wrong{"`" + of + "` is not [LEAST, MOST]"};
  const Span made{seconds(value[0], of), seconds(value[1], of)};
  if (*made.last < made.first) throw Wrong{"`" + of + "` ends before it begins"};
  return made;
}

template <class Names>
[[noreturn]] void unknown(const std::string& what, const std::string& name, const Names& names) {
  const auto meant = syntax::nearest(name, names);
  throw Wrong{"there is no " + what + " `" + name + "`" +
              (meant.empty() ? "" : "; did you mean `" + std::string(meant) + "`?")};
}

class Reader {
public:
  Reader(const Executable& of, SimulationSettings& to) : executable(of), settings(to) {}

  void platform(const Json& file) {
    allow(file, {"kind", "actions", "events", "interrupts"}, "the platform");
    for (const auto& [name, value] : object(file, "actions")) action(name, value);
    for (const auto& [name, value] : object(file, "events"))
      every(signal(name, false), name, value);
    for (const auto& [name, value] : object(file, "interrupts"))
      every(signal(name, true), name, value);
  }

  void script(const Json& file) {
    allow(file, {"actions", "signals"}, "the script");
    for (const auto& [name, value] : object(file, "actions"))
      for (const auto& ending : array(value, name))
        settings.endings[actionNamed(name)].push_back(endingOf(name, ending));
    if (file.contains("signals")) {
      // The script is what happens; nothing else comes.
      std::ranges::fill(settings.signals, std::nullopt);
      for (const auto& said : array(file["signals"], "signals"))
        settings.script.push_back(saidOf(said));
    }
    std::ranges::stable_sort(settings.script, {}, &SimulationSettings::Said::date);
  }

private:
  static void allow(const Json& value, const std::vector<std::string>& known,
                    const std::string& where) {
    if (!value.is_object()) throw Wrong{where + " is no object"};
    for (const auto& [key, _] : value.items())
      if (std::ranges::find(known, key) == known.end()) unknown("member", key, known);
  }

  static Json::object_t object(const Json& file, const std::string& key) {
    if (!file.contains(key)) return {};
    if (!file[key].is_object()) throw Wrong{"`" + key + "` is no object"};
    return file[key].get<Json::object_t>();
  }

  static const Json& array(const Json& value, const std::string& of) {
    if (!value.is_array()) throw Wrong{"`" + of + "` is no list"};
    return value;
  }

  [[nodiscard]] std::uint32_t actionNamed(const std::string& name) const {
    const auto& all = executable.model.performed;
    const auto found = std::ranges::find(all, name, &codegen::Performed::skill);
    if (found == all.end()) {
      std::vector<std::string> names;
      for (const auto& each : all) names.push_back(each.skill);
      unknown("basic skill", name, names);
    }
    return static_cast<std::uint32_t>(found - all.begin());
  }

  [[nodiscard]] std::uint32_t signal(const std::string& name, bool interrupts) const {
    const auto& all = executable.model.signals;
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (all[i].interrupts != interrupts) continue;
      if (all[i].name == name) return i;
      names.push_back(all[i].name);
    }
    unknown(interrupts ? "skill with `:interrupt`" : "event", name, names);
  }

  [[nodiscard]] std::uint32_t resultNamed(std::uint32_t action, const std::string& name) const {
    const auto& all = executable.model.performed[action].results;
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      const auto& word = all[i].tag.empty() ? all[i].status : all[i].tag;
      if (word == name) return i;
      names.push_back(word);
    }
    unknown("result of `" + executable.model.performed[action].skill + "`", name, names);
  }

  void action(const std::string& name, const Json& value) {
    const auto index = actionNamed(name);
    auto& action = settings.actions[index];
    allow(value, {"duration", "stops", "results"}, "`" + name + "`");
    if (value.contains("duration")) action.duration = span(value["duration"], name + ".duration");
    if (value.contains("stops")) action.stops = span(value["stops"], name + ".stops");
    if (!value.contains("results")) return;
    std::ranges::fill(action.weights, 0U);
    unsigned sum = 0;
    for (const auto& [result, weight] : object(value, "results")) {
      if (!weight.is_number_unsigned() || weight.get<std::uint64_t>() > 1'000'000)
        throw Wrong{"the weight of `" + result + "` is no natural number up to a million"};
      sum += action.weights[resultNamed(index, result)] = weight.get<unsigned>();
    }
    if (sum == 0) throw Wrong{"no result of `" + name + "` has a weight"};
  }

  void every(std::uint32_t index, const std::string& name, const Json& value) {
    if (value.is_null()) {
      settings.signals[index].reset();
      return;
    }
    settings.signals[index] = span(value, name);
    if (settings.signals[index]->first == 0)
      throw Wrong{"`" + name + "` may come again at once: let some time pass"};
  }

  [[nodiscard]] SimulationSettings::Ending endingOf(const std::string& name,
                                                    const Json& value) const {
    allow(value, {"result", "after"}, "a run of `" + name + "`");
    SimulationSettings::Ending ending;
    if (value.contains("after")) ending.after = seconds(value["after"], name + ".after");
    if (value.contains("result")) {
      if (!value["result"].is_string()) throw Wrong{"`" + name + ".result` is no word"};
      ending.result = resultNamed(actionNamed(name), value["result"].get<std::string>());
    }
    return ending;
  }

  [[nodiscard]] SimulationSettings::Said saidOf(const Json& value) const {
    allow(value, {"at", "event", "interrupt"}, "a signal");
    const bool interrupts = value.contains("interrupt");
    const std::string key = interrupts ? "interrupt" : "event";
    if (!value.contains("at") || !value.contains(key) || !value[key].is_string())
      throw Wrong{"a signal has `at` and either `event` or `interrupt`"};
    return {seconds(value["at"], "at"), signal(value[key].get<std::string>(), interrupts)};
  }

  const Executable& executable;
  SimulationSettings& settings;
};

} // namespace

std::optional<std::string> readPlatform(std::string_view text, const Executable& executable,
                                        SimulationSettings& settings) {
  try {
    Reader(executable, settings).platform(parsed(text));
  } catch (const Wrong& wrong) {
    return wrong.why;
  }
  return std::nullopt;
}

std::optional<std::string> readScript(std::string_view text, const Executable& executable,
                                      SimulationSettings& settings) {
  try {
    Reader(executable, settings).script(parsed(text));
  } catch (const Wrong& wrong) {
    return wrong.why;
  }
  return std::nullopt;
}

bool speaksForEnvironment(std::string_view text) {
  const auto value = Json::parse(text, nullptr, false);
  return value.is_object() &&
         (value.contains("signals") || value.contains("events") || value.contains("interrupts"));
}

std::expected<std::string, std::string> platformKind(std::string_view text) {
  try {
    const auto value = parsed(text);
    if (!value.contains("kind")) return "simulated";
    if (!value["kind"].is_string()) throw Wrong{"`kind` must be a string"};
    return value["kind"].get<std::string>();
  } catch (const Wrong& wrong) {
    return std::unexpected(wrong.why);
  }
}

} // namespace proskill::runtime
