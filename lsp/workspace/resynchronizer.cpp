#include "lsp/workspace/resynchronizer.h"

#include "lsp/protocol/numbers.h"
#include "lsp/workspace/notebooks.h"

#include <algorithm>
#include <utility>

namespace proskill::lsp {

namespace {

constexpr const char* kRegistration = "proskill/wholeTexts";
constexpr const char* kDidChange = "textDocument/didChange";

/// Cells of notebooks are synchronized by messages of their own.
bool isAskedFor(const InexactTexts::value_type& text) {
  return text.second.kind == ide::TextKind::File;
}

Json registration() {
  Json languages = Json::array();
  for (const char* language : {"proskill", "fiacre"}) languages.push_back({{"language", language}});
  return {{"id", kRegistration},
          {"method", kDidChange},
          {"registerOptions",
           {{"documentSelector", std::move(languages)},
            {"syncKind", protocol::TextDocumentSyncKind::Full}}}};
}

} // namespace

void Resynchronizer::update(const InexactTexts& now) {
  auto push = [&](const std::string& uri, Json list) {
    if (!client.pullDiagnostics)
      peer.notify("textDocument/publishDiagnostics",
                  {{"uri", uri}, {"diagnostics", std::move(list)}});
  };
  for (const auto& [path, text] : last)
    if (text.isLost && !lostIn(now, path)) push(text.uri, Json::array());
  for (const auto& [path, text] : now)
    if (text.isLost && !lostIn(last, path)) push(text.uri, diagnostics(text));
  last = now;
  askForWholeTexts(client.dynamicTexts && std::ranges::any_of(now, isAskedFor));
}

void Resynchronizer::askForWholeTexts(bool wanted) {
  if (std::exchange(isAsking, wanted) == wanted) return;
  if (wanted)
    return peer.ask("client/registerCapability",
                    {{"registrations", Json::array({registration()})}});
  // the protocol spells the member like this
  peer.ask("client/unregisterCapability",
           {{"unregisterations", Json::array({{{"id", kRegistration}, {"method", kDidChange}}})}});
}

const char* Resynchronizer::remedy(const InexactText& lost) const {
  if (lost.kind == ide::TextKind::Cell) return kReopenNotebook;
  return client.dynamicTexts ? "; the editor is asked to send the whole text with the next edit"
                             : "; please close the file and open it again";
}

std::string Resynchronizer::explanation(const InexactText& lost) const {
  return std::string("the text in the editor is not known to ProSkill") + remedy(lost);
}

Json Resynchronizer::diagnostics(const InexactText& lost) const {
  const Json start{{"line", 0}, {"character", 0}};
  return Json::array({{{"range", {{"start", start}, {"end", start}}},
                       {"severity", protocol::DiagnosticSeverity::Error},
                       {"source", "proskill"},
                       {"message", explanation(lost)}}});
}

} // namespace proskill::lsp
