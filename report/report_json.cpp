#include "report/report_json.h"

#include "syntax/text/position.h"

namespace proskill::report {

namespace {

/// Line and column from 1; the column counts characters.
OrderedJson placeJson(const syntax::Document& document, syntax::Offset at) {
  auto place = syntax::toEditor(document.text(), document.lines(), at, syntax::Encoding::Utf32);
  return {{"line", place.line + 1}, {"column", place.character + 1}};
}

} // namespace

OrderedJson locationJson(const analysis::Program& program, analysis::Location location) {
  const auto& file = program.files[location.file];
  return {{"file", file.path.generic_string()},
          {"begin", placeJson(file.document, location.range.begin)},
          {"end", placeJson(file.document, location.range.end)},
          {"bytes", {location.range.begin, location.range.end}}};
}

namespace {

/// Seconds as an exact string and as a number.
OrderedJson secondsJson(syntax::Rational value) {
  return {
      {"exact", syntax::toString(value)},
      {"seconds", static_cast<double>(value.numerator) / static_cast<double>(value.denominator)}};
}

OrderedJson momentJson(const ide::Moment& moment) {
  OrderedJson json = secondsJson(moment.seconds);
  json["strict"] = moment.strict;
  return json;
}

} // namespace

OrderedJson stepJson(const analysis::Program& program, const ide::TraceStep& step) {
  OrderedJson json{{"actor", step.actor}, {"description", step.description}};
  json["location"] = step.location ? locationJson(program, *step.location) : OrderedJson();
  json["date"] = secondsJson(step.date);
  json["delay"] = secondsJson(step.delay);
  json["earliest"] = momentJson(step.earliest);
  json["latest"] = step.latest ? momentJson(*step.latest) : OrderedJson();
  json["changes"] = OrderedJson::array();
  for (const auto& change : step.changes)
    json["changes"].push_back(
        {{"variable", change.variable}, {"before", change.before}, {"after", change.after}});
  json["why"] = step.why;
  json["relevant"] = step.relevant;
  json["causes"] = step.causes;
  json["transitions"] = step.transitions;
  json["origins"] = step.origins;
  return json;
}

OrderedJson traceJson(const analysis::Program& program, const ide::Trace& trace) {
  OrderedJson initial = OrderedJson::object();
  for (const auto& variable : trace.initial) initial[variable.variable] = variable.after;
  OrderedJson steps = OrderedJson::array();
  for (const auto& step : trace.steps) steps.push_back(stepJson(program, step));
  OrderedJson made{{"summary", trace.summary}, {"initial", initial}, {"steps", steps}};
  if (trace.loop) made["loop"] = *trace.loop;
  if (trace.end) made["end"] = secondsJson(*trace.end);
  return made;
}

const ide::Trace* shownTrace(const ide::VerdictRow& row, ShowTraces traces) {
  if (!row.trace || traces == ShowTraces::None) return nullptr;
  return traces == ShowTraces::All || row.bad() ? &*row.trace : nullptr;
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
  if (!row.reason.empty()) json["reason"] = row.reason;
  json["steps"] = row.steps ? OrderedJson(*row.steps) : OrderedJson();
  const ide::Trace* trace = shownTrace(row, traces);
  json["trace"] = trace ? traceJson(program, *trace) : OrderedJson();
  return json;
}

OrderedJson explorationJson(const verify::Exploration& exploration) {
  return {{"classes", exploration.classes},   {"markings", exploration.markings},
          {"domains", exploration.domains},   {"transitions", exploration.transitions},
          {"bytes", exploration.bytes},       {"seconds", exploration.seconds},
          {"complete", exploration.complete}, {"stopped", exploration.stopped},
          {"known", exploration.known}};
}

OrderedJson reportHeadJson(const VerifyReport& report) {
  OrderedJson json{
      {"version", 1},
      {"program", report.program.files.front().path.string()},
      {"main", report.mainSkill.empty() ? OrderedJson() : OrderedJson(report.mainSkill)},
      {"unit", secondsJson(report.model.unit)}};
  if (!report.backend.empty()) json["backend"] = report.backend;
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
