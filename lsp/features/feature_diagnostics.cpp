#include "analysis/program/originals.h"
#include "analysis/program/stop.h"
#include "ide/description/diagnostics.h"
#include "lsp/features/platform.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/diagnostics.h"
#include "lsp/protocol/numbers.h"
#include "lsp/verification/verdict_json.h"
#include "lsp/workspace/fingerprint.h"
#include "report/uri.h"

#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace proskill::lsp {

namespace {

using syntax::Code;

protocol::DiagnosticSeverity severityOf(syntax::Severity severity) {
  switch (severity) {
  case syntax::Severity::Error: return protocol::DiagnosticSeverity::Error;
  case syntax::Severity::Warning: return protocol::DiagnosticSeverity::Warning;
  case syntax::Severity::Hint: return protocol::DiagnosticSeverity::Hint;
  }
  return protocol::DiagnosticSeverity::Error;
}

/// Whether editors show the code faded: removing it would change nothing.
bool isUnnecessary(Code code) {
  constexpr std::array kCodes{Code::UnreachableStatement, Code::UnusedSkill,    Code::UnusedEvent,
                              Code::UnusedStateVariable,  Code::UnusedResource, Code::UnusedLabel,
                              Code::UnusedInput};
  return std::ranges::find(kCodes, code) != kCodes.end();
}

std::optional<protocol::DiagnosticTag> tagOf(Code code) {
  if (isUnnecessary(code)) return protocol::DiagnosticTag::Unnecessary;
  if (code == Code::DeprecatedName) return protocol::DiagnosticTag::Deprecated;
  return std::nullopt;
}

void writeCode(rpc::JsonWriter& json, std::string_view code, const ClientFeatures& client) {
  json.member("code", code);
  const auto link = client.manual ? client.manual->linkTo(code) : std::string();
  if (!link.empty()) json.key("codeDescription").open('{').member("href", link).close('}');
}

void writeRelated(rpc::JsonWriter& json, const syntax::Diagnostic& diagnostic,
                  const Json& elsewhere, const Converter& convert) {
  json.key("relatedInformation").open('[');
  if (!elsewhere.is_null()) json.value(elsewhere);
  for (const auto& entry : diagnostic.related) {
    if (!convert.isShown(entry.location.file)) continue;
    convert.write(json.open('{').key("location"), entry.location);
    json.member("message", entry.message).close('}');
  }
  json.close(']');
}

void writeFixes(rpc::JsonWriter& json, const syntax::Diagnostic& diagnostic,
                const Converter& convert) {
  json.key("data").open('{').key("fixes").open('[');
  for (const auto& fix : diagnostic.fixes) {
    json.open('{').member("title", fix.title).member("uri", convert.uri(fix.location.file));
    convert.write(json.key("range"), fix.location.file, fix.location.range);
    json.member("newText", fix.text).close('}');
  }
  json.close(']').close('}');
}

/// Identifies a list of items, across sessions.
std::string resultIdOf(const Json& items) { return fingerprint(rpc::dump(items)); }

/// `unchanged` if the client has this result already.
Json report(Json items, const Json& previous) {
  auto id = resultIdOf(items);
  if (previous == id) return {{"kind", "unchanged"}, {"resultId", id}};
  return {{"kind", "full"}, {"resultId", id}, {"items", std::move(items)}};
}

Json itemsOf(const Request& request, const std::filesystem::path& path) {
  return request.settings->diagnostics
             ? diagnosticsOf(request.snapshot, path, request.client, *request.verdicts)
             : Json::array();
}

Answer documentDiagnostics(const Request& request) {
  auto path = documentFile(request);
  if (!path) return std::unexpected(path.error());
  return report(itemsOf(request, *path), rpc::memberAt(request.params, {"previousResultId"}));
}

using Previous = std::map<std::filesystem::path, std::pair<std::string, Json>>;

/// Previous results of the client, by path: the URI and the result's identifier.
Previous previousOf(const Json& params) {
  Previous result;
  const Json& list = rpc::memberAt(params, {"previousResultIds"});
  if (!list.is_array()) return result;
  for (const auto& each : list)
    if (const Json& uri = rpc::memberAt(each, {"uri"}); uri.is_string())
      result[pathOf(uri.get<std::string>())] = {uri, rpc::memberAt(each, {"value"})};
  return result;
}

Json itemOf(const Request& request, const std::filesystem::path& path, const Previous& previous) {
  auto before = previous.find(path);
  auto item =
      report(itemsOf(request, path), before == previous.end() ? Json() : before->second.second);
  auto open = request.snapshot.open().find(path);
  const bool isOpen = open != request.snapshot.open().end();
  item["uri"] = isOpen ? open->second.uri : report::toUri(path);
  item["version"] = isOpen ? Json(open->second.version) : Json();
  return item;
}

/// An empty report for a file that was deleted, to clear what the client shows.
Json goneItem(const std::string& uri) {
  return {{"uri", uri}, {"version", nullptr}, {"kind", "full"}, {"items", Json::array()}};
}

/// Diagnostics of all files of the workspace; in parts if the client supports it.
Answer workspaceDiagnostics(const Request& request) {
  const auto previous = previousOf(request.params);
  std::vector<std::filesystem::path> files;
  for (const auto& file : request.snapshot.files())
    if (request.snapshot.kindOf(file) != ide::TextKind::Notebook) files.push_back(file);
  Json items = Json::array();
  auto give = [&](Json item) {
    if (request.progress->wantsParts())
      request.progress->part({{"items", Json::array({std::move(item)})}});
    else
      items.push_back(std::move(item));
  };
  request.progress->begin("Checking programs");
  std::size_t done = 0;
  for (const auto& path : files) {
    if (request.cancellation.isCancelled()) break;
    give(itemOf(request, path, previous));
    ++done;
    request.progress->report(fmt::format("{} of {} files", done, files.size()),
                             static_cast<unsigned>(100 * done / files.size()));
  }
  for (const auto& [path, told] : previous)
    if (!request.snapshot.knows(path)) give(goneItem(told.first));
  return Json{{"items", items}};
}

} // namespace

Json diagnosticJson(const ide::Finding& finding, const Converter& convert,
                    const ClientFeatures& client, const Json& elsewhere) {
  const auto& diagnostic = *finding.diagnostic;
  rpc::JsonWriter json;
  convert.write(json.open('{').key("range"), diagnostic.location.file, diagnostic.location.range);
  json.member("severity", severityOf(diagnostic.severity));
  writeCode(json, syntax::info(diagnostic.code).id, client);
  json.member("source", "proskill");
  json.member("message", diagnostic.message);
  if (const auto tag = tagOf(diagnostic.code); client.diagnosticTags && tag)
    json.key("tags").open('[').value(*tag).close(']');
  if (client.relatedInformation && (!elsewhere.is_null() || !diagnostic.related.empty()))
    writeRelated(json, diagnostic, elsewhere, convert);
  if (!diagnostic.fixes.empty()) writeFixes(json, diagnostic, convert);
  return rpc::written(json.close('}').str());
}

Json diagnosticsOf(const ide::Snapshot& snapshot, const std::filesystem::path& path,
                   const ClientFeatures& client, const ide::Verdicts& verdicts) {
  Json result = Json::array();
  std::map<const analysis::Program*, analysis::ProgramOriginals> known;
  for (const auto& finding : ide::diagnostics(snapshot, path)) {
    analysis::stopIfAsked();
    const auto& program = finding.owner->program;
    const Converter convert(program, snapshot.open(), client.encoding);
    auto& originals = known.try_emplace(&program, program).first->second;
    const auto original = originals.of(finding.diagnostic->location);
    result.push_back(
        diagnosticJson(finding, convert, client, original ? relatedOriginal(*original) : Json()));
  }
  for (auto& platform : platformDiagnostics(snapshot, path, client))
    result.push_back(std::move(platform));
  for (auto& verdict : verdictDiagnostics(verdicts, snapshot, path, client))
    result.push_back(std::move(verdict));
  return result;
}

void addDiagnostics(Registry& registry) {
  registry.capabilities["diagnosticProvider"] = {{"identifier", "proskill"},
                                                 {"interFileDependencies", true},
                                                 {"workspaceDiagnostics", true},
                                                 {"workDoneProgress", true}};
  registry.add("textDocument/diagnostic", documentDiagnostics);
  registry.add("workspace/diagnostic", workspaceDiagnostics, rpc::Priority::Background);
}

} // namespace proskill::lsp
