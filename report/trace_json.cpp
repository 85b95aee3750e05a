#include "report/report_json.h"
#include "report/sources.h"

#include "syntax/text/position.h"

/// The JSON of traces. It is a file of its own, since recordings of runs need no more of this
/// folder.
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
  OrderedJson made = traceJsonWithoutSteps(program, trace);
  for (const auto& step : trace.steps) made["steps"].push_back(stepJson(program, step));
  return made;
}

OrderedJson traceJsonWithoutSteps(const analysis::Program& program, const ide::Trace& trace) {
  OrderedJson initial = OrderedJson::object();
  for (const auto& variable : trace.initial) initial[variable.variable] = variable.after;
  OrderedJson made{{"summary", trace.summary},
                   {"sources", sourcesJson(program)},
                   {"initial", initial},
                   {"steps", OrderedJson::array()}};
  if (trace.loop) made["loop"] = *trace.loop;
  if (trace.end) made["end"] = secondsJson(*trace.end);
  return made;
}

} // namespace proskill::report
