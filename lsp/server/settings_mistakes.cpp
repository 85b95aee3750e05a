#include "lsp/server/settings_mistakes.h"

#include "lsp/protocol/numbers.h"
#include "report/uri.h"
#include "syntax/text/position.h"

namespace proskill::lsp {

namespace {

Json rangeOf(const report::SettingsMistake& mistake, syntax::Encoding encoding) {
  const syntax::LineIndex lines(mistake.text);
  auto position = [&](syntax::Offset at) {
    const auto [line, character] = syntax::toEditor(mistake.text, lines, at, encoding);
    return Json{{"line", line}, {"character", character}};
  };
  return {{"start", position(mistake.at.begin)}, {"end", position(mistake.at.end)}};
}

Json diagnosticOf(const report::SettingsMistake& mistake, syntax::Encoding encoding) {
  return {{"range", rangeOf(mistake, encoding)},
          {"severity", protocol::DiagnosticSeverity::Error},
          {"source", "proskill"},
          {"message", mistake.description}};
}

} // namespace

void SettingsMistakes::publish(Mistakes now) {
  if (now == published) return;
  auto send = [&](const std::filesystem::path& file, Json diagnostics) {
    peer.notify("textDocument/publishDiagnostics",
                {{"uri", report::toUri(file)}, {"diagnostics", std::move(diagnostics)}});
  };
  for (const auto& [file, mistake] : published)
    if (!now.contains(file)) send(file, Json::array());
  for (const auto& [file, mistake] : now)
    send(file, Json::array({diagnosticOf(mistake, client.encoding)}));
  published = std::move(now);
}

} // namespace proskill::lsp
