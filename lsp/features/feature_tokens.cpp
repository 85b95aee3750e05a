#include "lsp/protocol/convert.h"
#include "lsp/protocol/kept_parts.h"
#include "lsp/protocol/token_parts.h"

#include <array>
#include <atomic>

namespace proskill::lsp {

namespace {

/// In the order of `ide::TokenType`.
constexpr std::array kTypes{"keyword",   "property", "comment",  "string",     "number",
                            "operator",  "function", "variable", "enumMember", "event",
                            "parameter", "type",     "resource", "interface",  "namespace",
                            "decorator", "label"};
/// In the order of the bits of `ide::TokenModifier`.
constexpr std::array kModifiers{"definition", "modification", "unused"};

/// The last answer for a text, to send the next one as changes.
struct Known {
  std::string id;
  TokenAnswer tokens;
};

class Tokens {
public:
  Answer full(const Request& request) {
    auto view = documentView(request);
    if (!view) return std::unexpected(view.error());
    return whole(*next(request, *view, last.find(uriOf(request)).get()));
  }

  Answer changed(const Request& request) {
    const auto id = textIn(request.params, "previousResultId");
    if (!id) return std::unexpected(id.error());
    auto view = documentView(request);
    if (!view) return std::unexpected(view.error());
    const auto before = last.find(uriOf(request));
    const auto after = next(request, *view, before.get());
    if (!before || before->id != *id) return whole(*after);
    return Json{{"resultId", after->id},
                {"edits", rpc::written(tokenEdits(before->tokens, after->tokens))}};
  }

private:
  static std::string uriOf(const Request& request) { return request.params["textDocument"]["uri"]; }
  static Json whole(const Known& known) {
    return {{"resultId", known.id}, {"data", rpc::written(allTokens(known.tokens))}};
  }

  std::shared_ptr<const Known> next(const Request& request, const ide::View& view,
                                    const Known* before) {
    auto tokens =
        tokenAnswer(view, request.client.encoding, before ? before->tokens : TokenAnswer());
    auto known = std::make_shared<const Known>(Known{std::to_string(++lastId), std::move(tokens)});
    last.keep(uriOf(request), known);
    return known;
  }

  LastOfTexts<Known> last;
  std::atomic<std::uint64_t> lastId = 0;
};

Answer rangeTokens(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  auto range = rangeIn(*view, request.params, request.client.encoding);
  if (!range) return std::unexpected(range.error());
  return Json{{"data", encoded(*view, ide::tokens(*view, *range), request.client.encoding)}};
}

} // namespace

void addTokens(Registry& registry) {
  auto tokens = std::make_shared<Tokens>();
  registry.add("textDocument/semanticTokens/full",
               [tokens](const Request& request) { return tokens->full(request); });
  registry.add("textDocument/semanticTokens/full/delta",
               [tokens](const Request& request) { return tokens->changed(request); });
  registry.add("textDocument/semanticTokens/range", rangeTokens);
  registry.capabilities["semanticTokensProvider"] = {
      {"legend", {{"tokenTypes", kTypes}, {"tokenModifiers", kModifiers}}},
      {"range", true},
      {"full", {{"delta", true}}}};
}

} // namespace proskill::lsp
