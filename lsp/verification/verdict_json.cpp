#include "lsp/verification/verdict_json.h"

#include "lsp/protocol/numbers.h"
#include "report/ordered_json.h"
#include "report/uri.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::lsp {

namespace {

Json orNull(const std::optional<analysis::Location>& location, const Converter& convert) {
  return location ? convert.location(*location) : Json();
}

/// The first line of a range, so that not a whole skill is underlined.
analysis::Location firstLine(const analysis::Program& program, analysis::Location location) {
  const std::string_view text = program.files[location.file].document.text();
  const auto end = text.substr(0, location.range.end).find_first_of("\r\n", location.range.begin);
  if (end != std::string_view::npos) location.range.end = static_cast<syntax::Offset>(end);
  return location;
}

Json waypointsJson(const std::vector<ide::Waypoint>& way, const Converter& convert) {
  Json places = Json::array();
  for (const auto& point : way)
    places.push_back(
        {{"location", convert.location(point.location)}, {"message", point.description}});
  return places;
}

/// \pre the property has a location
Json diagnosticJson(const ide::PropertyVerdict& property, const analysis::Program& program,
                    analysis::ProgramOriginals& originals, const Converter& convert,
                    const ClientFeatures& client) {
  Json json{
      {"range", convert.range(firstLine(program, *property.location))},
      {"severity", property.weight == codegen::Weight::Error
                       ? protocol::DiagnosticSeverity::Error
                       : protocol::DiagnosticSeverity::Warning},
      {"code", property.kind},
      {"source", "proskill verify"},
      {"message", fmt::format("{}: {}{}{}", property.description, ide::toString(property.verdict),
                              property.summary.empty() ? "" : ". ", property.summary)},
      {"data", {{"kind", "verdict"}, {"name", property.name}, {"program", convert.uri(0)}}}};
  if (!client.relatedInformation) return json;
  auto related = waypointsJson(property.way, convert);
  if (const auto original = originals.of(*property.location))
    related.insert(related.begin(), relatedOriginal(*original));
  if (!related.empty()) json["relatedInformation"] = std::move(related);
  return json;
}

Json stepJson(const OrderedJson& step, const analysis::Program& program, const Converter& convert) {
  Json json;
  for (const auto* member : {"actor", "description", "date", "delay", "earliest", "latest",
                             "changes", "why", "relevant", "causes", "transitions", "origins"})
    json[member] = step.at(member);
  json["location"] = orNull(locationIn(program, step.at("location")), convert);
  return json;
}

struct Actor {
  std::string kind;
  Json skill; ///< of the branch or watchdog
};

/// Finds out the kind of an actor in a trace by its name, as codegen/ forms it.
Actor actorNamed(const analysis::Program& program, std::string_view name) {
  constexpr std::string_view kBranch = " branch ";
  constexpr std::string_view kWatchdog = "watchdog of ";
  if (auto at = name.find(kBranch); at != std::string_view::npos)
    return {"branch", name.substr(0, at)};
  if (name.starts_with(kWatchdog)) return {"watchdog", name.substr(kWatchdog.size())};
  if (program.skills.find(name)) return {"skill", name};
  if (program.events.find(name)) return {"event", nullptr};
  return {program.stateVariables.find(name) ? "sv" : "environment", nullptr};
}

} // namespace

Json relatedOriginal(const analysis::Original& original) {
  const Json at{{"line", original.line - 1}, {"character", original.column - 1}};
  return {{"location",
           {{"uri", report::toUri(original.file)}, {"range", {{"start", at}, {"end", at}}}}},
          {"message", "from here: " + original.what}};
}

Json stepsJson(const analysis::Program& program, const OrderedJson& steps,
               const Converter& convert) {
  Json all = Json::array();
  for (const auto& step : steps) all.push_back(stepJson(step, program, convert));
  return all;
}

Json actorsJson(const analysis::Program& program, const OrderedJson& steps) {
  Json actors = Json::array();
  std::vector<std::string> known;
  for (const auto& step : steps) {
    auto name = step.at("actor").get<std::string>();
    if (std::ranges::find(known, name) != known.end()) continue;
    auto actor = actorNamed(program, name);
    actors.push_back({{"name", name}, {"kind", actor.kind}, {"skill", actor.skill}});
    known.push_back(std::move(name));
  }
  return actors;
}

Json variablesJson(const analysis::Program& program, const OrderedJson& initial) {
  Json variables = Json::array();
  for (const auto& [name, value] : initial.items())
    variables.push_back(
        {{"name", name}, {"kind", program.stateVariables.find(name) ? "sv" : "status"}});
  return variables;
}

Json textsJson(const analysis::Program& program, const ide::OpenTexts& open) {
  const Converter convert(program, open, syntax::Encoding::Utf8);
  Json texts = Json::array();
  for (analysis::FileId i = 0; i < program.files.size(); ++i) {
    if (!convert.isShown(i)) continue;
    auto text = open.find(program.files[i].path);
    texts.push_back({{"uri", convert.uri(i)},
                     {"version", text == open.end() ? Json() : Json(text->second.version)}});
  }
  return texts;
}

Json textsJson(const ide::ProgramVerdicts& verdicts, const Converter& convert) {
  Json texts = Json::array();
  const auto& files = verdicts.program->program.files;
  for (analysis::FileId i = 0; i < files.size(); ++i) {
    if (!convert.isShown(i)) continue;
    auto version = verdicts.versions.find(files[i].path);
    texts.push_back(
        {{"uri", convert.uri(i)},
         {"version", version == verdicts.versions.end() ? Json() : Json(version->second)}});
  }
  return texts;
}

Json verdictJson(const ide::PropertyVerdict& property, const Converter& convert) {
  return {{"name", property.name},
          {"kind", property.kind},
          {"subject", property.subject},
          {"description", property.description},
          {"verdict", ide::toString(property.verdict)},
          {"good", property.good()},
          {"severity", property.weight == codegen::Weight::Error ? "error" : "warning"},
          {"location", orNull(property.location, convert)},
          {"reason", property.reason},
          {"summary", property.summary},
          {"pending", property.pending},
          {"steps", property.steps ? Json(*property.steps) : Json()}};
}

Json verdictsJson(const ide::ProgramVerdicts& verdicts, const Converter& convert) {
  Json all = Json::array();
  for (const auto& property : verdicts.properties) all.push_back(verdictJson(property, convert));
  return all;
}

Json changedVerdictsJson(const ide::ProgramVerdicts& before, const ide::ProgramVerdicts& now,
                         const Converter& convert) {
  Json changed = Json::array();
  for (std::size_t i = 0; i < now.properties.size(); ++i)
    if (now.properties[i] != before.properties[i])
      changed.push_back(verdictJson(now.properties[i], convert));
  return changed;
}

Json countsJson(const std::vector<ide::PropertyVerdict>& properties) {
  std::size_t good = 0;
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::size_t pending = 0;
  for (const auto& property : properties) {
    if (property.good()) ++good;
    if (property.pending) ++pending;
    if (property.bad()) ++(property.weight == codegen::Weight::Error ? errors : warnings);
  }
  return {{"total", properties.size()},
          {"good", good},
          {"errors", errors},
          {"warnings", warnings},
          {"inconclusive", properties.size() - good - errors - warnings - pending},
          {"pending", pending}};
}

Json explorationSummary(const verify::Exploration& exploration) {
  const auto classes = static_cast<double>(exploration.classes);
  return {{"classes", exploration.classes},
          {"markings", exploration.markings},
          {"transitions", exploration.transitions},
          {"bytes", exploration.bytes},
          {"seconds", exploration.seconds},
          {"rate", exploration.seconds > 0 ? classes / exploration.seconds : 0},
          {"complete", exploration.complete},
          {"stopped", exploration.stopped}};
}

Json progressJson(const worker::WorkerProgress& progress) {
  return {{"decided", progress.decided}, {"total", progress.total},
          {"classes", progress.classes}, {"markings", progress.markings},
          {"waiting", progress.waiting}, {"bytes", progress.bytes},
          {"seconds", progress.seconds}, {"rate", progress.rate()}};
}

Json traceOf(const Verified& verified, const std::string& name, bool stale,
             const Converter& convert) {
  const auto& program = verified.verdicts->program->program;
  const auto& all = verified.verdicts->properties;
  const auto& property = *std::ranges::find(all, name, &ide::PropertyVerdict::name);
  const auto trace = OrderedJson::parse(*verified.traces.at(name));
  return {{"name", name},
          {"description", property.description},
          {"verdict", ide::toString(property.verdict)},
          {"program", convert.uri(0)},
          {"main", verified.mainSkill.empty() ? Json() : Json(verified.mainSkill)},
          {"stale", stale},
          {"summary", trace.at("summary")},
          {"sources", trace.at("sources")},
          {"texts", textsJson(*verified.verdicts, convert)},
          {"initial", trace.at("initial")},
          {"variables", variablesJson(program, trace.at("initial"))},
          {"actors", actorsJson(program, trace.at("steps"))},
          {"steps", stepsJson(program, trace.at("steps"), convert)},
          {"loop", trace.contains("loop") ? Json(trace.at("loop")) : Json()}};
}

Json verdictDiagnostics(const ide::Verdicts& verdicts, const ide::Snapshot& snapshot,
                        const std::filesystem::path& file, const ClientFeatures& client) {
  Json result = Json::array();
  if (verdicts.empty()) return result;
  for (const auto& view : snapshot.views(file)) {
    const auto current = ide::currentVerdicts(verdicts, view);
    if (!current) continue;
    const Converter convert(current->program->program, snapshot.open(), client.encoding);
    analysis::ProgramOriginals originals(view.program());
    for (const auto& property : current->properties) {
      if (!property.bad() || !property.location || property.location->file != view.file) continue;
      auto diagnostic = diagnosticJson(property, view.program(), originals, convert, client);
      if (std::ranges::find(result, diagnostic) == result.end())
        result.push_back(std::move(diagnostic));
    }
  }
  return result;
}

} // namespace proskill::lsp
