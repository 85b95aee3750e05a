#include "ide/completion/signature_help.h"
#include "ide/features/hover.h"
#include "lsp/features/platform.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/markup.h"

namespace proskill::lsp {

namespace {

Answer hover(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  auto found = ide::hover(at->view, at->at, *request.verdicts);
  if (!found) found = platformHover(request.snapshot, at->view, at->at);
  if (!found) return nullptr;
  const Converter convert(at->view, request);
  return Json{{"contents", markupContent(found->text, request.client.markdownHover)},
              {"range", convert.range(at->view.file, found->range)}};
}

/// Offsets in labels are in UTF-16, whatever encoding was negotiated for texts.
Json labelOf(const ide::Signature& signature, syntax::Range range, const ClientFeatures& client) {
  const auto& label = signature.label;
  if (!client.labelOffsets) return label.substr(range.begin, range.length());
  const syntax::LineIndex lines(label);
  auto column = [&](syntax::Offset at) {
    return syntax::toEditor(label, lines, at, syntax::Encoding::Utf16).character;
  };
  return Json::array({column(range.begin), column(range.end)});
}

Json parametersJson(const ide::Signature& signature, const ClientFeatures& client) {
  Json parameters = Json::array();
  for (const auto& parameter : signature.parameters) {
    Json json{{"label", labelOf(signature, parameter.label, client)}};
    if (!parameter.documentation.empty()) {
      ide::Markup text;
      text.prose(parameter.documentation);
      json["documentation"] = markupContent(text, client.markdownSignature);
    }
    parameters.push_back(std::move(json));
  }
  return parameters;
}

Answer signatureHelp(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  auto found = ide::signatureHelp(at->view, at->at);
  if (!found) return nullptr;
  Json signature{{"label", found->label}, {"parameters", parametersJson(*found, request.client)}};
  if (!found->documentation.empty())
    signature["documentation"] =
        markupContent(found->documentation, request.client.markdownSignature);
  // a number beyond the parameters means that none is active
  const auto active = found->active.value_or(found->parameters.size());
  signature["activeParameter"] = active;
  return Json{{"signatures", Json::array({signature})},
              {"activeSignature", 0},
              {"activeParameter", active}};
}

} // namespace

void addHover(Registry& registry) {
  registry.capabilities["hoverProvider"] = true;
  registry.capabilities["signatureHelpProvider"] = {{"triggerCharacters", Json::array({"(", " "})},
                                                    {"retriggerCharacters", Json::array({")"})}};
  registry.add("textDocument/hover", hover);
  registry.add("textDocument/signatureHelp", signatureHelp);
}

} // namespace proskill::lsp
