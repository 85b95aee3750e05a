#include "report/source_place.h"
#include "report/verify_report.h"

#include <ostream>
#include <set>

namespace proskill::cli {

namespace {

using Json = nlohmann::ordered_json;

Json physical(const analysis::Program& program, analysis::Location location) {
  SourcePlaces places(program);
  auto begin = places.begin(location);
  auto end = places.end(location);
  return {{"physicalLocation",
           {{"artifactLocation", {{"uri", places.path(location.file)}}},
            {"region",
             {{"startLine", begin.line},
              {"startColumn", begin.column},
              {"endLine", end.line},
              {"endColumn", end.column}}}}}};
}

Json flowStep(const VerifyReport& report, const ide::TraceStep& step) {
  auto text = step.actor + " " + step.words + " at " + syntax::toString(step.date) + " s";
  Json location{{"message", {{"text", text}}}};
  if (step.location) location.update(physical(report.program, *step.location));
  return {{"location", location}};
}

std::string_view level(const ide::VerdictRow& row) {
  if (!row.bad()) return "note";
  return row.check->weight == codegen::Weight::Error ? "error" : "warning";
}

Json resultJson(const VerifyReport& report, const ide::VerdictRow& row) {
  std::string text = row.check->words + ": " + std::string(ide::toString(row.verdict));
  if (!row.reason.empty()) text += " (" + row.reason + ")";
  Json json{{"ruleId", row.check->kind},
            {"level", level(row)},
            {"message", {{"text", text}}},
            {"partialFingerprints", {{"property/v1", row.check->name}}}};
  if (row.location) json["locations"] = Json::array({physical(report.program, *row.location)});
  if (row.trace) {
    Json steps = Json::array();
    for (const auto& step : row.trace->steps) steps.push_back(flowStep(report, step));
    if (!steps.empty())
      json["codeFlows"] = Json::array({{{"threadFlows", Json::array({{{"locations", steps}}})}}});
  }
  return json;
}

} // namespace

void writeSarif(std::ostream& out, const VerifyReport& report) {
  std::set<std::string> kinds;
  Json results = Json::array();
  for (const auto& row : report.result.rows) {
    if (row.good()) continue;
    kinds.insert(row.check->kind);
    results.push_back(resultJson(report, row));
  }
  Json rules = Json::array();
  for (const auto& kind : kinds) rules.push_back({{"id", kind}, {"name", kind}});
  Json run{{"tool",
            {{"driver", {{"name", "proskill"}, {"version", PROSKILL_VERSION}, {"rules", rules}}}}},
           {"columnKind", "unicodeCodePoints"},
           {"results", results}};
  Json log{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
           {"version", "2.1.0"},
           {"runs", Json::array({run})}};
  out << log.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

} // namespace proskill::cli
