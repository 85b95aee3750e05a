#include "report/report_json.h"

#include "report/original_json.h"
#include "syntax/text/position.h"

namespace proskill::report {

const ide::Trace* shownTrace(const ide::VerdictRow& row, ShowTraces traces) {
  if (!row.trace || traces == ShowTraces::None) return nullptr;
  return traces == ShowTraces::All || row.bad() ? &*row.trace : nullptr;
}

/// The answer to a question for a time.
OrderedJson timeJson(const ide::MeasuredTime& time) {
  OrderedJson json{{"happens", time.happens}};
  if (!time.happens) return json;
  json["value"] = time.bounded ? momentJson(time.value) : OrderedJson();
  return json;
}

OrderedJson propertyJson(const analysis::Program& program, const ide::VerdictRow& row,
                         ShowTraces traces) {
  const auto& check = *row.check;
  OrderedJson json{{"name", check.name},
                   {"kind", check.kind},
                   {"subject", check.subject},
                   {"description", check.description},
                   {"verdict", ide::toString(row.verdict)},
                   {"good", row.good()},
                   {"severity", check.weight == codegen::Weight::Error ? "error" : "warning"}};
  json["location"] = row.location ? locationJson(program, *row.location) : OrderedJson();
  if (row.original) json["original"] = originalJson(*row.original);
  if (!row.reason.empty()) json["reason"] = row.reason;
  if (row.time) json["time"] = timeJson(*row.time);
  json["steps"] = row.steps ? OrderedJson(*row.steps) : OrderedJson();
  const ide::Trace* trace = shownTrace(row, traces);
  json["trace"] = trace ? traceJson(program, *trace) : OrderedJson();
  return json;
}

OrderedJson explorationJson(const verify::Exploration& exploration) {
  OrderedJson json{{"classes", exploration.classes},   {"markings", exploration.markings},
                   {"domains", exploration.domains},   {"transitions", exploration.transitions},
                   {"bytes", exploration.bytes},       {"seconds", exploration.seconds},
                   {"complete", exploration.complete}, {"stopped", exploration.stopped},
                   {"known", exploration.known}};
  if (exploration.ranks > 0)
    json["ranks"] = {{"count", exploration.ranks},
                     {"messages", exploration.messages},
                     {"bytes", exploration.sentBytes}};
  if (exploration.spilledBytes > 0) json["spilledBytes"] = exploration.spilledBytes;
  return json;
}

OrderedJson durationsJson(const std::vector<ide::SkillDuration>& durations) {
  const auto jsonOf = [](const std::optional<ide::MeasuredTime>& time) {
    return time ? timeJson(*time) : OrderedJson();
  };
  OrderedJson all = OrderedJson::array();
  for (const auto& each : durations)
    all.push_back({{"skill", each.skill},
                   {"text", ide::durationText(each)},
                   {"shortest", jsonOf(each.shortest)},
                   {"longest", jsonOf(each.longest)}});
  return all;
}

OrderedJson sizeRowsJson(const analysis::Program& program, const std::vector<ide::SizeRow>& rows) {
  OrderedJson all = OrderedJson::array();
  for (const auto& row : rows)
    all.push_back(
        {{"name", row.name},
         {"location", row.location ? locationJson(program, *row.location) : OrderedJson()},
         {"factor", row.factor},
         {"values", row.values},
         {"clocks", row.clocks},
         {"advice", row.advice}});
  return all;
}

OrderedJson sizeJson(const analysis::Program& program, const ide::SizeExplanation& size) {
  return {{"classes", size.counts.classes},
          {"states", size.counts.states},
          {"complete", size.counts.complete},
          {"stopped", size.counts.stopped},
          {"parts", sizeRowsJson(program, size.rows)},
          {"kinds", sizeRowsJson(program, size.kinds)},
          {"apart", size.apart}};
}

OrderedJson reportHeadJson(const VerifyReport& report) {
  OrderedJson json{
      {"version", 1},
      {"program", report.program.files.front().path.string()},
      {"main", report.mainSkill.empty() ? OrderedJson() : OrderedJson(report.mainSkill)},
      {"unit", secondsJson(report.model.unit)}};
  if (!report.backend.empty()) json["backend"] = report.backend;
  if (!report.durations.empty()) json["durations"] = durationsJson(report.durations);
  if (report.size) json["size"] = sizeJson(report.program, *report.size);
  return json;
}

OrderedJson reportJson(const VerifyReport& report) {
  auto json = reportHeadJson(report);
  json["properties"] = OrderedJson::array();
  for (const auto& row : report.result.rows)
    json["properties"].push_back(propertyJson(report.program, row, report.traces));
  json["exploration"] = explorationJson(report.result.exploration);
  return json;
}

} // namespace proskill::report
