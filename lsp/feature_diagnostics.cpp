#include "ide/diagnostics.h"
#include "lsp/convert.h"
#include "lsp/diagnostics.h"

namespace proskill::lsp {

namespace {

int severityOf(syntax::Severity severity) {
  switch (severity) {
  case syntax::Severity::Error: return 1;
  case syntax::Severity::Warning: return 2;
  case syntax::Severity::Hint: return 4;
  }
  return 1;
}

Json relatedJson(const syntax::Diagnostic& diagnostic, const Converter& convert) {
  Json related = Json::array();
  for (const auto& entry : diagnostic.related)
    related.push_back({{"location", convert.location(entry.location)}, {"message", entry.message}});
  return related;
}

Json fixesJson(const syntax::Diagnostic& diagnostic, const Converter& convert) {
  Json fixes = Json::array();
  for (const auto& fix : diagnostic.fixes)
    fixes.push_back({{"title", fix.title},
                     {"uri", convert.uri(fix.location.file)},
                     {"range", convert.range(fix.location)},
                     {"newText", fix.text}});
  return fixes;
}

Json report(Json items) { return {{"kind", "full"}, {"items", std::move(items)}}; }

Answer documentDiagnostics(const Request& request) {
  auto path = documentPath(request.params);
  if (!path) return std::unexpected(path.error());
  return report(diagnosticsOf(request.snapshot, *path, request.client));
}

/// Of every open text; a file that is not open has no version that the client could show them for.
Answer workspaceDiagnostics(const Request& request) {
  Json items = Json::array();
  for (const auto& [path, text] : request.snapshot.open()) {
    if (request.cancellation.isCancelled()) break;
    auto item = report(diagnosticsOf(request.snapshot, path, request.client));
    item["uri"] = text.uri;
    item["version"] = text.version;
    items.push_back(std::move(item));
  }
  return Json{{"items", items}};
}

} // namespace

Json diagnosticJson(const ide::Finding& finding, const Converter& convert,
                    const ClientFeatures& client) {
  const auto& diagnostic = *finding.diagnostic;
  Json json{{"range", convert.range(diagnostic.location)},
            {"severity", severityOf(diagnostic.severity)},
            {"code", syntax::info(diagnostic.code).id},
            {"source", "proskill"},
            {"message", diagnostic.message}};
  if (client.relatedInformation && !diagnostic.related.empty())
    json["relatedInformation"] = relatedJson(diagnostic, convert);
  if (!diagnostic.fixes.empty()) json["data"] = {{"fixes", fixesJson(diagnostic, convert)}};
  return json;
}

Json diagnosticsOf(const ide::Snapshot& snapshot, const std::filesystem::path& path,
                   const ClientFeatures& client) {
  Json result = Json::array();
  for (const auto& finding : ide::diagnostics(snapshot, path)) {
    const Converter convert(finding.owner->program, snapshot.open(), client.encoding);
    result.push_back(diagnosticJson(finding, convert, client));
  }
  return result;
}

void addDiagnostics(Registry& registry) {
  registry.capabilities["diagnosticProvider"] = {
      {"identifier", "proskill"}, {"interFileDependencies", true}, {"workspaceDiagnostics", true}};
  registry.add("textDocument/diagnostic", documentDiagnostics);
  registry.add("workspace/diagnostic", workspaceDiagnostics, Priority::Background);
}

} // namespace proskill::lsp
