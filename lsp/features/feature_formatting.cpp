#include "lsp/protocol/convert.h"
#include "lsp/protocol/edits.h"
#include "syntax/format/format.h"

#include <set>

namespace proskill::lsp {

namespace {

using Edits = std::vector<syntax::TextEdit>;

/// There is one style, so options of the request (`tabSize`, …) are ignored.
Answer formatting(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  return textEdits(Converter(*view, request), view->file, syntax::format(view->document()));
}

Answer formatRanges(const Request& request, const ide::View& view, const Json& ranges) {
  Edits all;
  for (const auto& range : ranges) {
    auto lines = rangeOf(view, range, request.client.encoding);
    if (!lines) return std::unexpected(lines.error());
    for (auto& edit : syntax::formatRange(view.document(), *lines))
      if (std::ranges::find(all, edit) == all.end()) all.push_back(std::move(edit));
  }
  std::ranges::sort(all, {}, [](const auto& edit) { return edit.range.begin; });
  return textEdits(Converter(view, request), view.file, all);
}

Answer rangeFormatting(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  auto range = rangeIn(*view, request.params, request.client.encoding);
  if (!range) return std::unexpected(range.error());
  return textEdits(Converter(*view, request), view->file,
                   syntax::formatRange(view->document(), *range));
}

Answer rangesFormatting(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  if (!request.params.contains("ranges") || !request.params["ranges"].is_array())
    return std::unexpected(invalidParams("`ranges` is missing"));
  return formatRanges(request, *view, request.params["ranges"]);
}

Answer onTypeFormatting(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const auto typed = textIn(request.params, "ch");
  if (!typed) return std::unexpected(typed.error());
  auto edits = typed->size() == 1 ? syntax::formatTyped(at->view.document(), at->at, typed->front())
                                  : Edits{};
  return textEdits(Converter(at->view, request), at->view.file, edits);
}

/// The offset of the beginning of a line.
std::expected<syntax::Offset, rpc::RpcError> lineBegin(const Request& request,
                                                       const ide::View& view, const Json& number) {
  return offsetOf(view, {{"line", number}, {"character", 0U}}, request.client.encoding);
}

Answer indent(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  const auto& lines = rpc::memberAt(request.params, {"lines"});
  if (!lines.is_array()) return std::unexpected(invalidParams("`lines` is missing"));
  std::set<std::uint32_t> numbers;
  for (const auto& number : lines) {
    const auto begin = lineBegin(request, *view, number);
    if (!begin) return std::unexpected(begin.error());
    numbers.insert(view->document().lines().position(*begin).line);
  }
  const std::vector<std::uint32_t> typed(numbers.begin(), numbers.end());
  return textEdits(Converter(*view, request), view->file,
                   syntax::formatLines(view->document(), typed));
}

} // namespace

void addFormatting(Registry& registry) {
  registry.add("textDocument/formatting", formatting);
  registry.add("textDocument/rangeFormatting", rangeFormatting);
  registry.add("textDocument/rangesFormatting", rangesFormatting);
  registry.add("textDocument/onTypeFormatting", onTypeFormatting);
  registry.add("proskill/indent", indent);
  registry.capabilities["documentFormattingProvider"] = true;
  registry.capabilities["documentRangeFormattingProvider"] = {{"rangesSupport", true}};
  registry.capabilities["documentOnTypeFormattingProvider"] = {{"firstTriggerCharacter", "\n"},
                                                               {"moreTriggerCharacter", {")"}}};
}

} // namespace proskill::lsp
