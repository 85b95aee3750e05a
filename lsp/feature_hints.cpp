#include "ide/inlay_hints.h"
#include "lsp/convert.h"

namespace proskill::lsp {

namespace {

struct AskedRange {
  ide::View view;
  syntax::Range range;
};

std::expected<AskedRange, RpcError> askedRange(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  const auto encoding = request.client.encoding;
  auto begin = offsetOf(*view, memberAt(request.params, {"range", "start"}), encoding);
  if (!begin) return std::unexpected(begin.error());
  auto end = offsetOf(*view, memberAt(request.params, {"range", "end"}), encoding);
  if (!end) return std::unexpected(end.error());
  return AskedRange{std::move(*view), {*begin, std::max(*begin, *end)}};
}

/// 1: type, 2: parameter.
int kindOf(ide::HintKind kind) { return kind == ide::HintKind::ArgumentType ? 2 : 1; }

Answer inlayHint(const Request& request) {
  auto asked = askedRange(request);
  if (!asked) return std::unexpected(asked.error());
  const Converter convert(asked->view, request);
  Json result = Json::array();
  for (const auto& hint : ide::inlayHints(asked->view, asked->range)) {
    Json json{{"position", convert.position(asked->view.file, hint.at)},
              {"label", hint.label},
              {"kind", kindOf(hint.kind)},
              {"paddingLeft", hint.kind != ide::HintKind::ArgumentType}};
    if (!hint.tooltip.empty()) json["tooltip"] = hint.tooltip;
    result.push_back(std::move(json));
  }
  return result;
}

/// What a debugger has not come to yet is not shown.
Answer inlineValue(const Request& request) {
  auto asked = askedRange(request);
  if (!asked) return std::unexpected(asked.error());
  const auto& stopped = memberAt(request.params, {"context", "stoppedLocation", "end"});
  auto last = offsetOf(asked->view, stopped, request.client.encoding);
  if (last) asked->range.end = std::min(asked->range.end, std::max(*last, asked->range.begin));
  const Converter convert(asked->view, request);
  Json result = Json::array();
  for (const auto& variable : ide::inlineVariables(asked->view, asked->range))
    result.push_back({{"range", convert.range(asked->view.file, variable.range)},
                      {"variableName", variable.name},
                      {"caseSensitiveLookup", true}});
  return result;
}

} // namespace

void addHints(Registry& registry) {
  registry.capabilities["inlayHintProvider"] = true;
  registry.capabilities["inlineValueProvider"] = true;
  registry.add("textDocument/inlayHint", inlayHint);
  registry.add("textDocument/inlineValue", inlineValue);
}

} // namespace proskill::lsp
