#include "lsp/features/feature_fiacre.h"

#include "ide/fiacre/fiacre_rename.h"
#include "ide/fiacre/fiacre_text.h"
#include "ide/snapshot/fiacre_file.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/edits.h"
#include "lsp/protocol/folds_json.h"
#include "lsp/protocol/markup.h"
#include "lsp/protocol/outline_json.h"

/// Documents in Fiacre: their text alone answers.
namespace proskill::lsp {

namespace {

using fiacre::NameKind;

/// The protocol's `SymbolKind`.
int symbolKind(NameKind kind) {
  switch (kind) {
  case NameKind::Component: return 2; // module
  case NameKind::Process: return 5;   // class
  case NameKind::Property: return 7;
  case NameKind::Field: return 8;
  case NameKind::Channel: return 11; // interface
  case NameKind::Function:
  case NameKind::Extern:
  case NameKind::Task:
  case NameKind::Foreign: return 12;
  case NameKind::Variable:
  case NameKind::Parameter:
  case NameKind::Value: return 13;
  case NameKind::Constant: return 14;
  case NameKind::Tag: return 20; // key
  case NameKind::State:
  case NameKind::Constructor: return 22; // enum member
  case NameKind::Type: return 23;        // struct
  case NameKind::Port:
  case NameKind::Event: return 24;
  }
  return 13;
}

Answer documentSymbol(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  JsonWriter json;
  json.open('[');
  writeOutline(
      json, ide::FiacreText(view->text()).outline(), Converter(*view, request), view->file,
      [](const ide::FiacreEntry& entry) { return symbolKind(entry.kind); }, request);
  return listAnswer(request, json.close(']').str());
}

Answer hover(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const auto found = ide::FiacreText(at->view.text()).hover(at->at);
  if (!found) return nullptr;
  return Json{{"contents", markupContent(found->text, request.client.markdownHover)},
              {"range", Converter(at->view, request).range(at->view.file, found->range)}};
}

Answer definition(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  Json result = Json::array();
  if (const auto found = ide::FiacreText(at->view.text()).definition(at->at))
    result.push_back(Converter(at->view, request).location({at->view.file, *found}));
  return result;
}

Answer references(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const Converter convert(at->view, request);
  const bool all = memberAt(request.params, {"context", "includeDeclaration"}) == true;
  Json result = Json::array();
  for (const auto& use : ide::FiacreText(at->view.text()).uses(at->at, all))
    result.push_back(convert.location({at->view.file, use.range}));
  return result;
}

Answer prepareRename(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const auto found = ide::renameableInFiacre(at->view.text(), at->at);
  if (!found) return std::unexpected(RpcError{ErrorCode::RequestFailed, found.error()});
  return Json{{"range", Converter(at->view, request).range(at->view.file, *found)},
              {"placeholder", at->view.text().substr(found->begin, found->end - found->begin)}};
}

Answer rename(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const auto name = textIn(request.params, "newName");
  if (!name) return std::unexpected(name.error());
  auto places = ide::renameInFiacre(at->view.text(), at->at, *name);
  if (!places) return std::unexpected(RpcError{ErrorCode::RequestFailed, places.error()});
  const auto& path = at->view.program().files[at->view.file].path;
  return workspaceEdit({{path, std::move(*places)}}, *name, request);
}

/// 3 says that a place gives the name its meaning, 2 that it reads it.
Answer documentHighlight(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const Converter convert(at->view, request);
  Json result = Json::array();
  for (const auto& use : ide::FiacreText(at->view.text()).uses(at->at, true))
    result.push_back(
        {{"range", convert.range(at->view.file, use.range)}, {"kind", use.declares ? 3 : 2}});
  return result;
}

Answer foldingRange(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  return foldsAnswer(request, ide::FiacreText(view->text()).folds());
}

/// Nothing changes in a text that cannot be read.
Answer formatting(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  const auto edits = ide::formatFiacre(view->text());
  return textEdits(Converter(*view, request), view->file,
                   edits.value_or(std::vector<syntax::TextEdit>{}));
}

/// The edits that touch the range, of those of the whole text.
Answer rangeFormatting(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  auto range = rangeIn(*view, request.params, request.client.encoding);
  if (!range) return std::unexpected(range.error());
  auto edits = ide::formatFiacre(view->text()).value_or(std::vector<syntax::TextEdit>{});
  std::erase_if(edits, [&](const syntax::TextEdit& edit) {
    return edit.range.end < range->begin || range->end < edit.range.begin;
  });
  return textEdits(Converter(*view, request), view->file, edits);
}

Answer nothing(const Request& /*request*/) { return nullptr; }

Answer noProgram(const Request& /*request*/) {
  return std::unexpected(
      RpcError{ErrorCode::RequestFailed,
               "a model in Fiacre is no program: it is verified, and that is all"});
}

bool isInFiacre(const Request& request) {
  const auto path = documentPath(request.params);
  return path && ide::isFiacre(*path);
}

/// What a method does for a document in Fiacre; null where it does the same as for programs.
Handler forFiacre(const std::string& method) {
  static const std::map<std::string, Handler> kHandlers{
      {"proskill/trace", nullptr},
      {"proskill/verify", nullptr},
      {"textDocument/codeLens", nullptr},
      {"textDocument/completion", nullptr},
      {"textDocument/declaration", definition},
      {"textDocument/definition", definition},
      {"textDocument/diagnostic", nullptr},
      {"textDocument/documentHighlight", documentHighlight},
      {"textDocument/documentSymbol", documentSymbol},
      {"textDocument/foldingRange", foldingRange},
      {"textDocument/formatting", formatting},
      {"textDocument/hover", hover},
      {"textDocument/prepareRename", prepareRename},
      {"textDocument/rangeFormatting", rangeFormatting},
      {"textDocument/references", references},
      {"textDocument/rename", rename},
      {"textDocument/semanticTokens/full", nullptr},
      {"textDocument/semanticTokens/full/delta", nullptr},
      {"textDocument/semanticTokens/range", nullptr},
  };
  if (const auto found = kHandlers.find(method); found != kHandlers.end()) return found->second;
  if (method.starts_with("textDocument/")) return nothing;
  return method.starts_with("proskill/") ? Handler(noProgram) : nullptr;
}

} // namespace

void addFiacre(Registry& registry) {
  for (auto& [name, method] : registry.methods) {
    auto inFiacre = forFiacre(name);
    if (!inFiacre) continue;
    method.handler = [ofProgram = std::move(method.handler),
                      inFiacre = std::move(inFiacre)](const Request& request) {
      return isInFiacre(request) ? inFiacre(request) : ofProgram(request);
    };
  }
}

} // namespace proskill::lsp
