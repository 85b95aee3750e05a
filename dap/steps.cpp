#include "dap/steps.h"

#include "report/uri.h"

#include <fmt/format.h>

namespace proskill::dap {

namespace {

/// Place in the form of reports: file, begin and end, counted from 1.
Place placeInReport(const OrderedJson& json, const std::filesystem::path& base) {
  const auto& begin = json.at("begin");
  const auto& end = json.at("end");
  return {oneSpelling(base / json.at("file").get<std::string>()), begin.at("line").get<unsigned>(),
          begin.at("column").get<unsigned>(), end.at("line").get<unsigned>(),
          end.at("column").get<unsigned>()};
}

/// Place in the form of the language server, counted from 0.
std::optional<Place> placeOfProtocol(const OrderedJson& json) {
  const auto path = report::toPath(json.at("uri").get<std::string>());
  if (!path) return std::nullopt;
  const auto& begin = json.at("range").at("start");
  const auto& end = json.at("range").at("end");
  return Place{oneSpelling(*path), begin.at("line").get<unsigned>() + 1,
               begin.at("character").get<unsigned>() + 1, end.at("line").get<unsigned>() + 1,
               end.at("character").get<unsigned>() + 1};
}

std::optional<Place> placeOf(const OrderedJson& json, const std::filesystem::path& base) {
  if (!json.is_object()) return std::nullopt;
  if (json.contains("uri")) return placeOfProtocol(json);
  return placeInReport(json, base);
}

Step stepOf(const OrderedJson& json, const std::filesystem::path& base) {
  Step step;
  step.actor = json.at("actor").get<std::string>();
  step.description = json.at("description").get<std::string>();
  step.place = placeOf(json.at("location"), base);
  step.date = json.at("date").at("exact").get<std::string>();
  step.delay = json.at("delay").at("exact").get<std::string>();
  step.earliest = json.at("earliest").at("exact").get<std::string>();
  step.afterEarliest = json.at("earliest").at("strict").get<bool>();
  if (const auto& latest = json.at("latest"); !latest.is_null()) {
    step.latest = latest.at("exact").get<std::string>();
    step.beforeLatest = latest.at("strict").get<bool>();
  }
  for (const auto& change : json.at("changes"))
    step.changes.push_back({change.at("variable").get<std::string>(),
                            change.at("before").get<std::string>(),
                            change.at("after").get<std::string>()});
  step.transitions = json.at("transitions").get<std::vector<std::string>>();
  step.why = json.value("why", "");
  step.relevant = json.value("relevant", true);
  return step;
}

/// The language server sends the order of the variables separately from their values.
std::vector<verify::Change> initialOf(const OrderedJson& json) {
  std::vector<verify::Change> initial;
  const auto& values = json.at("initial");
  if (auto variables = json.find("variables"); variables != json.end()) {
    for (const auto& variable : *variables) {
      const auto name = variable.at("name").get<std::string>();
      initial.push_back({name, {}, values.at(name).get<std::string>()});
    }
    return initial;
  }
  for (const auto& [name, value] : values.items())
    initial.push_back({name, {}, value.get<std::string>()});
  return initial;
}

} // namespace

std::expected<Trace, std::string> readTrace(const OrderedJson& json,
                                            const std::filesystem::path& base) {
  try {
    Trace trace;
    trace.name = json.value("name", "");
    trace.description = json.value("description", "");
    trace.verdict = json.value("verdict", "");
    const auto inner = json.find("trace");
    const OrderedJson& whole = inner != json.end() ? *inner : json;
    trace.summary = whole.value("summary", "");
    trace.initial = initialOf(whole);
    for (const auto& step : whole.at("steps")) trace.steps.push_back(stepOf(step, base));
    return trace;
  } catch (const OrderedJson::exception& error) {
    return std::unexpected(fmt::format("not a trace: {}", error.what()));
  }
}

std::string windowOf(const Step& step) {
  const auto* open = step.afterEarliest ? "]" : "[";
  if (!step.latest) return fmt::format("{}{} s, …[", open, step.earliest);
  return fmt::format("{}{} s, {} s{}", open, step.earliest, *step.latest,
                     step.beforeLatest ? "[" : "]");
}

std::filesystem::path oneSpelling(const std::filesystem::path& path) {
  std::error_code error;
  auto found = std::filesystem::weakly_canonical(path, error);
  return error ? path.lexically_normal() : found;
}

} // namespace proskill::dap
