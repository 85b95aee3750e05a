#include "report/sarif.h"

#include "report/uri.h"

#include <ostream>

namespace proskill::cli {

using Json = nlohmann::ordered_json;

Json sarifFile(const SourcePlaces& places, syntax::FileId file) {
  return {{"uri", lsp::toUriReference(places.path(file))}};
}

Json sarifRegion(SourcePlaces& places, analysis::Location location) {
  const SourcePlace begin = places.begin(location);
  const SourcePlace end = places.end(location);
  return {{"startLine", begin.line},
          {"startColumn", begin.column},
          {"endLine", end.line},
          {"endColumn", end.column}};
}

Json sarifLocation(SourcePlaces& places, analysis::Location location) {
  return {{"physicalLocation",
           {{"artifactLocation", sarifFile(places, location.file)},
            {"region", sarifRegion(places, location)}}}};
}

void writeSarifLog(std::ostream& out, Json rules, Json results) {
  const Json driver{
      {"name", "proskill"}, {"version", PROSKILL_VERSION}, {"rules", std::move(rules)}};
  const Json run{{"tool", {{"driver", driver}}},
                 {"columnKind", "unicodeCodePoints"},
                 {"results", std::move(results)}};
  const Json log{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                 {"version", "2.1.0"},
                 {"runs", Json::array({run})}};
  out << log.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

} // namespace proskill::cli
