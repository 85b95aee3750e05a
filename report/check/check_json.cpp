#include "report/check/check_report.h"
#include "report/original_json.h"
#include "report/text/render.h"
#include "report/text/source_place.h"

#include <ostream>

namespace proskill::report {

namespace {

OrderedJson placeJson(SourcePlace place, syntax::Offset offset) {
  return {{"line", place.line}, {"column", place.column}, {"offset", offset}};
}

OrderedJson placeJson(SourcePlaces& places, analysis::Location location) {
  return {{"file", places.path(location.file)},
          {"begin", placeJson(places.begin(location), location.range.begin)},
          {"end", placeJson(places.end(location), location.range.end)}};
}

OrderedJson diagnosticJson(SourcePlaces& places, analysis::ProgramOriginals& originals,
                           const syntax::Diagnostic& diagnostic) {
  OrderedJson related = OrderedJson::array(), fixes = OrderedJson::array();
  for (const syntax::Related& it : diagnostic.related)
    related.push_back({{"message", it.message}, {"location", placeJson(places, it.location)}});
  for (const syntax::Fix& it : diagnostic.fixes)
    fixes.push_back(
        {{"title", it.title}, {"location", placeJson(places, it.location)}, {"text", it.text}});
  OrderedJson json{{"code", syntax::info(diagnostic.code).id},
                   {"severity", words(diagnostic.severity)},
                   {"message", diagnostic.message},
                   {"location", placeJson(places, diagnostic.location)},
                   {"related", related},
                   {"fixes", fixes}};
  if (const auto original = originals.of(diagnostic.location))
    json["original"] = originalJson(*original);
  return json;
}

} // namespace

void writeCheckJson(std::ostream& out, std::span<const CheckedProgram> programs) {
  OrderedJson diagnostics = OrderedJson::array();
  for (const CheckedProgram& checked : programs) {
    SourcePlaces places(checked.program);
    analysis::ProgramOriginals originals(checked.program);
    for (const syntax::Diagnostic& diagnostic : checked.diagnostics)
      diagnostics.push_back(diagnosticJson(places, originals, diagnostic));
  }
  const FindingCounts counts = countFindings(programs);
  const OrderedJson report{{"version", 1},
                           {"diagnostics", diagnostics},
                           {"summary",
                            {{"errors", counts.errors},
                             {"warnings", counts.warnings},
                             {"hints", counts.hints},
                             {"files", counts.files}}}};
  out << report.dump(2, ' ', false, OrderedJson::error_handler_t::replace) << '\n';
}

} // namespace proskill::report
