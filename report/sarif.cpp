#include "report/sarif.h"

#include "report/uri.h"

#include <ostream>

namespace proskill::report {

OrderedJson sarifFile(const SourcePlaces& places, syntax::FileId file) {
  return {{"uri", toUriReference(places.path(file))}};
}

OrderedJson sarifRegion(SourcePlaces& places, analysis::Location location) {
  const SourcePlace begin = places.begin(location);
  const SourcePlace end = places.end(location);
  return {{"startLine", begin.line},
          {"startColumn", begin.column},
          {"endLine", end.line},
          {"endColumn", end.column}};
}

OrderedJson sarifLocation(SourcePlaces& places, analysis::Location location) {
  return {{"physicalLocation",
           {{"artifactLocation", sarifFile(places, location.file)},
            {"region", sarifRegion(places, location)}}}};
}

void writeSarifLog(std::ostream& out, OrderedJson rules, OrderedJson results) {
  const OrderedJson driver{
      {"name", "proskill"}, {"version", PROSKILL_VERSION}, {"rules", std::move(rules)}};
  const OrderedJson run{{"tool", {{"driver", driver}}},
                        {"columnKind", "unicodeCodePoints"},
                        {"results", std::move(results)}};
  const OrderedJson log{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                        {"version", "2.1.0"},
                        {"runs", OrderedJson::array({run})}};
  out << log.dump(2, ' ', false, OrderedJson::error_handler_t::replace) << '\n';
}

} // namespace proskill::report
