#include "ide/features/inlay_hints.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/numbers.h"

namespace proskill::lsp {

namespace {

struct AskedRange {
  ide::View view;
  syntax::Range range;
};

std::expected<AskedRange, rpc::RpcError> askedRange(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  const auto encoding = request.client.encoding;
  auto begin = offsetOf(*view, rpc::memberAt(request.params, {"range", "start"}), encoding);
  if (!begin) return std::unexpected(begin.error());
  auto end = offsetOf(*view, rpc::memberAt(request.params, {"range", "end"}), encoding);
  if (!end) return std::unexpected(end.error());
  return AskedRange{std::move(*view), {*begin, std::max(*begin, *end)}};
}

/// 1: type, 2: parameter.
protocol::InlayHintKind kindOf(ide::HintKind kind) {
  return kind == ide::HintKind::ArgumentType ? protocol::InlayHintKind::Parameter
                                             : protocol::InlayHintKind::Type;
}

/// Adds what is needed only when the user points at a hint.
void addTooltip(Json& json, const ide::InlayHint& hint) { json["tooltip"] = hint.tooltip; }
void addLocation(Json& json, const ide::InlayHint& hint, const Converter& convert) {
  if (hint.about) json["label"][0]["location"] = convert.location(*hint.about);
}

/// A label with a link has to be a list of parts, here with one part.
Json labelOf(const ide::InlayHint& hint) {
  return hint.about ? Json::array({{{"value", hint.label}}}) : Json(hint.label);
}

const Json& textOfLabel(const Json& label) {
  return label.is_array() && !label.empty() ? rpc::memberAt(label[0], {"value"}) : label;
}

std::int64_t versionOf(const Request& request, const ide::View& view) {
  return request.snapshot.open().at(view.program().files[view.file].path).version;
}

Answer inlayHint(const Request& request) {
  auto asked = askedRange(request);
  if (!asked) return std::unexpected(asked.error());
  const Converter convert(asked->view, request);
  const bool laterTooltip = request.client.resolvedOfHints.contains("tooltip");
  const bool laterLocation = request.client.resolvedOfHints.contains("label.location");
  const Json data{{"textDocument", request.params["textDocument"]},
                  {"version", versionOf(request, asked->view)}};
  Json result = Json::array();
  for (const auto& hint : ide::inlayHints(asked->view, asked->range, *request.verdicts)) {
    Json json{{"position", convert.position(asked->view.file, hint.at)},
              {"label", labelOf(hint)},
              {"kind", kindOf(hint.kind)},
              {"paddingLeft", hint.kind != ide::HintKind::ArgumentType}};
    if (!laterTooltip) addTooltip(json, hint);
    if (!laterLocation) addLocation(json, hint, convert);
    if (laterTooltip || laterLocation) json["data"] = data;
    result.push_back(std::move(json));
  }
  return result;
}

/// Computes the hints again; the text must be unchanged.
Answer resolveHint(const Request& request) {
  const auto& data = rpc::memberAt(request.params, {"data"});
  if (data.is_null()) return request.params; // the hint was complete from the beginning
  const Request ofText{data, request.snapshot, request.client, request.cancellation};
  auto view = documentView(ofText);
  if (!view) return std::unexpected(view.error());
  if (rpc::memberAt(data, {"version"}) != versionOf(request, *view))
    return std::unexpected(
        rpc::RpcError{rpc::ErrorCode::ContentModified, "the text has changed since"});
  auto at = offsetOf(*view, rpc::memberAt(request.params, {"position"}), request.client.encoding);
  if (!at) return std::unexpected(at.error());
  Json json = request.params;
  for (const auto& hint :
       ide::inlayHints(*view, {*at - std::min(*at, 1U), *at}, *request.verdicts)) {
    if (hint.at != *at || textOfLabel(rpc::memberAt(json, {"label"})) != hint.label) continue;
    addTooltip(json, hint);
    addLocation(json, hint, Converter(*view, request));
  }
  return json;
}

/// Values after the debugger's position are omitted.
Answer inlineValue(const Request& request) {
  auto asked = askedRange(request);
  if (!asked) return std::unexpected(asked.error());
  const auto& stopped = rpc::memberAt(request.params, {"context", "stoppedLocation", "end"});
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
  registry.capabilities["inlayHintProvider"] = {{"resolveProvider", true}};
  registry.capabilities["inlineValueProvider"] = true;
  registry.add("textDocument/inlayHint", inlayHint);
  registry.add("inlayHint/resolve", resolveHint);
  registry.add("textDocument/inlineValue", inlineValue);
}

} // namespace proskill::lsp
