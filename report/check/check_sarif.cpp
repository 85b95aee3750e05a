#include "ide/description/explanation.h"
#include "report/check/check_report.h"
#include "report/original_json.h"
#include "report/sarif.h"
#include "report/text/source_place.h"

#include <ostream>

namespace proskill::report {

namespace {

std::string_view level(syntax::Severity severity) {
  switch (severity) {
  case syntax::Severity::Error: return "error";
  case syntax::Severity::Warning: return "warning";
  case syntax::Severity::Hint: return "note";
  }
  return {};
}

OrderedJson fixJson(SourcePlaces& places, const syntax::Fix& fix) {
  const OrderedJson replacement{{"deletedRegion", sarifRegion(places, fix.location)},
                                {"insertedContent", {{"text", fix.text}}}};
  const OrderedJson change{{"artifactLocation", sarifFile(places, fix.location.file)},
                           {"replacements", OrderedJson::array({replacement})}};
  return {{"description", {{"text", fix.title}}},
          {"artifactChanges", OrderedJson::array({change})}};
}

OrderedJson resultJson(SourcePlaces& places, analysis::ProgramOriginals& originals,
                       const syntax::Diagnostic& diagnostic) {
  OrderedJson result{
      {"ruleId", syntax::info(diagnostic.code).id},
      {"ruleIndex", static_cast<std::size_t>(diagnostic.code)},
      {"level", level(diagnostic.severity)},
      {"message", {{"text", diagnostic.message}}},
      {"locations", OrderedJson::array({sarifLocation(places, diagnostic.location)})}};
  OrderedJson related = OrderedJson::array(), fixes = OrderedJson::array();
  for (const syntax::Related& it : diagnostic.related) {
    OrderedJson location = sarifLocation(places, it.location);
    location["message"] = {{"text", it.message}};
    related.push_back(std::move(location));
  }
  if (const auto original = originals.of(diagnostic.location))
    related.push_back(sarifOriginal(*original));
  for (const syntax::Fix& it : diagnostic.fixes) fixes.push_back(fixJson(places, it));
  if (!related.empty()) result["relatedLocations"] = std::move(related);
  if (!fixes.empty()) result["fixes"] = std::move(fixes);
  return result;
}

/// All codes in the order of the table: the number of a code is its index.
OrderedJson rulesJson() {
  OrderedJson rules = OrderedJson::array();
  for (const syntax::CodeInfo& code : syntax::allCodes())
    rules.push_back({{"id", code.id},
                     {"shortDescription", {{"text", ide::titleOf(code)}}},
                     {"fullDescription", {{"text", ide::paragraphOf(code)}}},
                     {"help", {{"text", ide::paragraphOf(code)}}},
                     {"defaultConfiguration", {{"level", level(code.severity)}}}});
  return rules;
}

} // namespace

void writeCheckSarif(std::ostream& out, std::span<const CheckedProgram> programs) {
  OrderedJson results = OrderedJson::array();
  for (const CheckedProgram& checked : programs) {
    SourcePlaces places(checked.program);
    analysis::ProgramOriginals originals(checked.program);
    for (const syntax::Diagnostic& diagnostic : checked.diagnostics)
      results.push_back(resultJson(places, originals, diagnostic));
  }
  writeSarifLog(out, rulesJson(), std::move(results));
}

} // namespace proskill::report
