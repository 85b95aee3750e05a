#include "ide/features/navigation.h"
#include "ide/features/structure.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/numbers.h"

namespace proskill::lsp {

namespace {

using Places = std::vector<analysis::Location>;

Json locations(const Cursor& cursor, const Request& request, const Places& places) {
  const Converter convert(cursor.view, request);
  Json result = Json::array();
  for (auto place : places) result.push_back(convert.location(place));
  return result;
}

/// Handler for a request whose answer is a list of places for a cursor position.
Handler places(std::function<Places(const Cursor&, const Request&)> find) {
  return [find = std::move(find)](const Request& request) -> Answer {
    auto at = cursor(request);
    if (!at) return std::unexpected(at.error());
    return locations(*at, request, find(*at, request));
  };
}

Places onePlace(std::optional<analysis::Location> place) {
  return place ? Places{*place} : Places{};
}

/// The file whose path is at the cursor, as a list of one place: its beginning.
Json linkedFile(const Cursor& cursor, const Request& request) {
  const auto& view = cursor.view;
  const Json begin{{"line", 0}, {"character", 0}};
  Json result = Json::array();
  for (const auto& link : ide::links(view.program().files[view.file].path, view.document()))
    if (link.range.touches({cursor.at, cursor.at}) && request.snapshot.isFile(link.target))
      result.push_back({{"uri", uriOf(link.target, request.snapshot)},
                        {"range", {{"start", begin}, {"end", begin}}}});
  return result;
}

Answer definition(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  if (auto file = linkedFile(*at, request); !file.empty()) return file;
  return locations(*at, request, onePlace(ide::definition(at->view, at->at)));
}

bool wantsDeclaration(const Json& params) {
  auto context = params.find("context");
  return context != params.end() && context->is_object() &&
         context->value("includeDeclaration", false);
}

protocol::DocumentHighlightKind highlightKind(analysis::Role role) {
  using enum protocol::DocumentHighlightKind;
  switch (role) {
  case analysis::Role::Read:
  case analysis::Role::Call:
  case analysis::Role::Interrupt: return Read;
  case analysis::Role::Definition:
  case analysis::Role::Write: return Write;
  case analysis::Role::Mention: return Text;
  }
  return Text;
}

Answer documentHighlight(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const Converter convert(at->view, request);
  Json result = Json::array();
  for (const auto& occurrence : ide::highlights(at->view, at->at))
    result.push_back(
        {{"range", convert.range(occurrence.at)}, {"kind", highlightKind(occurrence.role)}});
  return result;
}

} // namespace

void addNavigation(Registry& registry) {
  registry.add("textDocument/definition", definition);
  registry.add("textDocument/declaration", definition);
  registry.add("textDocument/typeDefinition", places([](const Cursor& at, const Request&) {
                 return onePlace(ide::typeDefinition(at.view, at.at));
               }));
  registry.add("textDocument/implementation", places([](const Cursor& at, const Request&) {
                 return ide::implementations(at.view, at.at);
               }));
  registry.add("textDocument/references", places([](const Cursor& at, const Request& request) {
                 return ide::references(at.view, at.at, wantsDeclaration(request.params));
               }));
  registry.add("textDocument/documentHighlight", documentHighlight);
  for (const auto* capability :
       {"definitionProvider", "declarationProvider", "typeDefinitionProvider",
        "implementationProvider", "referencesProvider", "documentHighlightProvider"})
    registry.capabilities[capability] = true;
}

} // namespace proskill::lsp
