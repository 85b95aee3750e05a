#include "report/original_json.h"
#include "report/sarif.h"
#include "report/text/source_place.h"
#include "report/verify_report.h"
#include "syntax/text/seconds.h"

#include <ostream>
#include <set>

namespace proskill::report {

namespace {

OrderedJson physical(const analysis::Program& program, analysis::Location location) {
  SourcePlaces places(program);
  return sarifLocation(places, location);
}

OrderedJson flowStep(const VerifyReport& report, const ide::TraceStep& step) {
  auto text = step.actor + " " + step.description + " at " + syntax::secondsText(step.date);
  OrderedJson location{{"message", {{"text", text}}}};
  if (step.location) location.update(physical(report.program, *step.location));
  return {{"location", location}};
}

std::string_view level(const ide::VerdictRow& row) {
  if (!row.bad()) return "note";
  return row.check->weight == codegen::Weight::Error ? "error" : "warning";
}

OrderedJson resultJson(const VerifyReport& report, const ide::VerdictRow& row) {
  std::string text = row.check->description + ": " + std::string(ide::toString(row.verdict));
  if (!row.reason.empty()) text += " (" + row.reason + ")";
  OrderedJson json{{"ruleId", row.check->kind},
                   {"level", level(row)},
                   {"message", {{"text", text}}},
                   {"partialFingerprints", {{"property/v1", row.check->name}}}};
  if (row.location)
    json["locations"] = OrderedJson::array({physical(report.program, *row.location)});
  if (row.original) json["relatedLocations"] = OrderedJson::array({sarifOriginal(*row.original)});
  if (const ide::Trace* trace = shownTrace(row, report.traces)) {
    OrderedJson steps = OrderedJson::array();
    for (const auto& step : trace->steps) steps.push_back(flowStep(report, step));
    if (!steps.empty())
      json["codeFlows"] =
          OrderedJson::array({{{"threadFlows", OrderedJson::array({{{"locations", steps}}})}}});
  }
  return json;
}

} // namespace

void writeSarif(std::ostream& out, const VerifyReport& report) {
  std::set<std::string> kinds;
  OrderedJson results = OrderedJson::array();
  for (const auto& row : report.result.rows) {
    if (row.good()) continue;
    kinds.insert(row.check->kind);
    results.push_back(resultJson(report, row));
  }
  OrderedJson rules = OrderedJson::array();
  for (const auto& kind : kinds) rules.push_back({{"id", kind}, {"name", kind}});
  writeSarifLog(out, std::move(rules), std::move(results));
}

} // namespace proskill::report
