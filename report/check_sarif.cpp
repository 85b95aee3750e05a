#include "ide/description/explanation.h"
#include "report/check_report.h"
#include "report/source_place.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <ostream>

namespace proskill::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string_view level(syntax::Severity severity) {
  switch (severity) {
  case syntax::Severity::Error: return "error";
  case syntax::Severity::Warning: return "warning";
  case syntax::Severity::Hint: return "note";
  }
  return {};
}

/// A path as a URI reference: `/` between its parts, all that is special escaped.
std::string uri(std::string_view path) {
  constexpr std::string_view kPlain = "-._~/";
  std::string text = path.starts_with('/') ? "file://" : "";
  for (char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (byte < 0x80 && std::isalnum(byte)) || kPlain.contains(c);
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    if (plain)
      text += c;
    else
      text.append({'%', kDigits[byte >> 4], kDigits[byte & 15]});
  }
  return text;
}

Json regionJson(SourcePlaces& places, analysis::Location location) {
  const SourcePlace begin = places.begin(location), end = places.end(location);
  return {{"startLine", begin.line},
          {"startColumn", begin.column},
          {"endLine", end.line},
          {"endColumn", end.column}};
}

Json artifactJson(const SourcePlaces& places, syntax::FileId file) {
  return {{"uri", uri(places.path(file))}};
}

Json sarifLocation(SourcePlaces& places, analysis::Location location) {
  return {{"physicalLocation",
           {{"artifactLocation", artifactJson(places, location.file)},
            {"region", regionJson(places, location)}}}};
}

Json fixJson(SourcePlaces& places, const syntax::Fix& fix) {
  const Json replacement{{"deletedRegion", regionJson(places, fix.location)},
                         {"insertedContent", {{"text", fix.text}}}};
  const Json change{{"artifactLocation", artifactJson(places, fix.location.file)},
                    {"replacements", Json::array({replacement})}};
  return {{"description", {{"text", fix.title}}}, {"artifactChanges", Json::array({change})}};
}

Json resultJson(SourcePlaces& places, const syntax::Diagnostic& diagnostic) {
  Json result{{"ruleId", syntax::info(diagnostic.code).id},
              {"ruleIndex", static_cast<std::size_t>(diagnostic.code)},
              {"level", level(diagnostic.severity)},
              {"message", {{"text", diagnostic.message}}},
              {"locations", Json::array({sarifLocation(places, diagnostic.location)})}};
  Json related = Json::array(), fixes = Json::array();
  for (const syntax::Related& it : diagnostic.related) {
    Json location = sarifLocation(places, it.location);
    location["message"] = {{"text", it.message}};
    related.push_back(std::move(location));
  }
  for (const syntax::Fix& it : diagnostic.fixes) fixes.push_back(fixJson(places, it));
  if (!related.empty()) result["relatedLocations"] = std::move(related);
  if (!fixes.empty()) result["fixes"] = std::move(fixes);
  return result;
}

/// All codes in the order of the table, so that a code's number is its index.
Json rulesJson() {
  Json rules = Json::array();
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
  Json results = Json::array();
  for (const CheckedProgram& checked : programs) {
    SourcePlaces places(checked.program);
    for (const syntax::Diagnostic& diagnostic : checked.diagnostics)
      results.push_back(resultJson(places, diagnostic));
  }
  const Json driver{{"name", "proskill"}, {"version", PROSKILL_VERSION}, {"rules", rulesJson()}};
  const Json run{
      {"tool", {{"driver", driver}}}, {"columnKind", "unicodeCodePoints"}, {"results", results}};
  const Json log{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                 {"version", "2.1.0"},
                 {"runs", Json::array({run})}};
  out << log.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

} // namespace proskill::cli
