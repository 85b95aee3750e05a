#include "lsp/features/feature_fiacre.h"

#include "ide/fiacre/fiacre_rename.h"
#include "ide/fiacre/fiacre_text.h"
#include "ide/snapshot/fiacre_file.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/edits.h"
#include "lsp/protocol/folds_json.h"
#include "lsp/protocol/markup.h"
#include "lsp/protocol/numbers.h"
#include "lsp/protocol/outline_json.h"

/// Handlers for Fiacre documents, which need only their text.
namespace proskill::lsp {

/// The names of the features' handlers for ProSkill.
namespace of_fiacre {
namespace {

using fiacre::NameKind;

/// The protocol's `SymbolKind`.
protocol::SymbolKind symbolKind(NameKind kind) {
  switch (kind) {
  case NameKind::Component: return protocol::SymbolKind::Module;
  case NameKind::Process: return protocol::SymbolKind::Class;
  case NameKind::Property: return protocol::SymbolKind::Property;
  case NameKind::Field: return protocol::SymbolKind::Field;
  case NameKind::Channel: return protocol::SymbolKind::Interface;
  case NameKind::Function:
  case NameKind::Extern:
  case NameKind::Task:
  case NameKind::Foreign: return protocol::SymbolKind::Function;
  case NameKind::Variable:
  case NameKind::Parameter:
  case NameKind::Value: return protocol::SymbolKind::Variable;
  case NameKind::Constant: return protocol::SymbolKind::Constant;
  case NameKind::Tag: return protocol::SymbolKind::Key;
  case NameKind::State:
  case NameKind::Constructor: return protocol::SymbolKind::EnumMember;
  case NameKind::Type: return protocol::SymbolKind::Struct;
  case NameKind::Port:
  case NameKind::Event: return protocol::SymbolKind::Event;
  }
  return protocol::SymbolKind::Variable;
}

Answer documentSymbol(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  rpc::JsonWriter json;
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
  const bool all = rpc::memberAt(request.params, {"context", "includeDeclaration"}) == true;
  Json result = Json::array();
  for (const auto& use : ide::FiacreText(at->view.text()).uses(at->at, all))
    result.push_back(convert.location({at->view.file, use.range}));
  return result;
}

Answer prepareRename(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const auto found = ide::renameableInFiacre(at->view.text(), at->at);
  if (!found) return std::unexpected(requestFailed(found.error()));
  return Json{{"range", Converter(at->view, request).range(at->view.file, *found)},
              {"placeholder", at->view.text().substr(found->begin, found->end - found->begin)}};
}

Answer rename(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const auto name = textIn(request.params, "newName");
  if (!name) return std::unexpected(name.error());
  auto places = ide::renameInFiacre(at->view.text(), at->at, *name);
  if (!places) return std::unexpected(requestFailed(places.error()));
  const auto& path = at->view.program().files[at->view.file].path;
  return workspaceEdit({{path, std::move(*places)}}, *name, request);
}

/// Kinds of the protocol: 3 is a declaration or assignment, 2 a read.
Answer documentHighlight(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const Converter convert(at->view, request);
  Json result = Json::array();
  for (const auto& use : ide::FiacreText(at->view.text()).uses(at->at, true))
    result.push_back({{"range", convert.range(at->view.file, use.range)},
                      {"kind", use.declares ? protocol::DocumentHighlightKind::Write
                                            : protocol::DocumentHighlightKind::Read}});
  return result;
}

Answer foldingRange(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  return foldsAnswer(request, ide::FiacreText(view->text()).folds());
}

/// A text with syntax errors is left unchanged.
Answer formatting(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  const auto edits = ide::formatFiacre(view->text());
  return textEdits(Converter(*view, request), view->file,
                   edits.value_or(std::vector<syntax::TextEdit>{}));
}

/// The edits of the whole text that touch the range.
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
  return std::unexpected(requestFailed("not supported for Fiacre models"));
}

bool isInFiacre(const Request& request) {
  const auto path = documentPath(request.params);
  return path && ide::isFiacre(*path);
}

/// The fixes for findings here.
Answer codeAction(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  const auto selection = rangeIn(*view, request.params, request.client.encoding);
  if (!selection) return std::unexpected(selection.error());
  const Converter convert(*view, request);
  const auto& path = view->program().files[view->file].path;
  Json result = Json::array();
  for (const auto& diagnostic : ide::readFiacre(path, std::string(view->text())).diagnostics) {
    const auto& at = diagnostic.location.range;
    if (at.end < selection->begin || selection->end < at.begin) continue;
    for (const auto& fix : diagnostic.fixes) {
      const syntax::TextEdit edit{fix.location.range, fix.text};
      Json changes = Json::object();
      changes[convert.uri(view->file)] = textEdits(convert, view->file, std::span(&edit, 1));
      result.push_back(Json{
          {"title", fix.title}, {"kind", "quickfix"}, {"edit", {{"changes", std::move(changes)}}}});
    }
  }
  return result;
}

Answer notDecided(const Request& /*request*/) {
  return std::unexpected(
      rpc::RpcError{rpc::ErrorCode::MethodNotFound, "not supported for Fiacre models"});
}

/// Handlers of methods for Fiacre documents; null: same as for programs.
const std::map<std::string, Handler, std::less<>>& handlers() {
  static const std::map<std::string, Handler, std::less<>> kHandlers{
      {"proskill/automaton", noProgram},
      {"proskill/edited", nullptr},
      {"proskill/explain", noProgram},
      {"proskill/indent", nothing},
      {"proskill/model", noProgram},
      {"proskill/recording", nullptr},
      {"proskill/simulate", nullptr},
      {"proskill/tests", noProgram},
      {"proskill/trace", nullptr},
      {"proskill/verify", nullptr},
      {"textDocument/codeAction", codeAction},
      {"textDocument/codeLens", nullptr},
      {"textDocument/completion", nullptr},
      {"textDocument/declaration", definition},
      {"textDocument/definition", definition},
      {"textDocument/diagnostic", nullptr},
      {"textDocument/documentHighlight", documentHighlight},
      {"textDocument/documentLink", nothing},
      {"textDocument/documentSymbol", documentSymbol},
      {"textDocument/foldingRange", foldingRange},
      {"textDocument/formatting", formatting},
      {"textDocument/hover", hover},
      {"textDocument/implementation", nothing},
      {"textDocument/inlayHint", nothing},
      {"textDocument/inlineValue", nothing},
      {"textDocument/linkedEditingRange", nothing},
      {"textDocument/onTypeFormatting", nothing},
      {"textDocument/prepareCallHierarchy", nothing},
      {"textDocument/prepareRename", prepareRename},
      {"textDocument/prepareTypeHierarchy", nothing},
      {"textDocument/rangeFormatting", rangeFormatting},
      {"textDocument/rangesFormatting", nothing},
      {"textDocument/references", references},
      {"textDocument/rename", rename},
      {"textDocument/selectionRange", nothing},
      {"textDocument/semanticTokens/full", nullptr},
      {"textDocument/semanticTokens/full/delta", nullptr},
      {"textDocument/semanticTokens/range", nullptr},
      {"textDocument/signatureHelp", nothing},
      {"textDocument/typeDefinition", nothing},
  };
  return kHandlers;
}

bool isOfDocument(std::string_view method) {
  return method.starts_with("textDocument/") || method.starts_with("proskill/");
}

Handler forFiacre(std::string_view method) {
  if (const auto found = handlers().find(method); found != handlers().end()) return found->second;
  return isOfDocument(method) ? Handler(notDecided) : nullptr;
}

} // namespace
} // namespace of_fiacre

bool isDecidedForFiacre(std::string_view method) {
  return !of_fiacre::isOfDocument(method) || of_fiacre::handlers().contains(method);
}

void addFiacre(Registry& registry) {
  for (auto& [name, method] : registry.methods) {
    auto inFiacre = of_fiacre::forFiacre(name);
    if (!inFiacre) continue;
    method.handler = [ofProgram = std::move(method.handler),
                      inFiacre = std::move(inFiacre)](const Request& request) {
      return of_fiacre::isInFiacre(request) ? inFiacre(request) : ofProgram(request);
    };
  }
}

} // namespace proskill::lsp
