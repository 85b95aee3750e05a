#include "ide/completion.h"
#include "ide/fiacre_file.h"
#include "ide/fiacre_text.h"
#include "lsp/convert.h"
#include "lsp/markup.h"
#include "lsp/symbol_json.h"

#include <fmt/format.h>

namespace proskill::lsp {

namespace {

using ide::CompletionKind;

/// The protocol's `CompletionItemKind`.
int kindOf(CompletionKind kind) {
  switch (kind) {
  case CompletionKind::Keyword:
  case CompletionKind::Statement: return 14;
  case CompletionKind::Field: return 10;
  case CompletionKind::Operator: return 24;
  case CompletionKind::Variable:
  case CompletionKind::Parameter: return 6;
  case CompletionKind::Value: return 20;
  case CompletionKind::Skill: return 3;
  case CompletionKind::Event: return 23;
  case CompletionKind::Resource: return 7;
  case CompletionKind::Tag: return 21;
  case CompletionKind::Label: return 18;
  case CompletionKind::Type: return 25;
  case CompletionKind::File: return 17;
  }
  return 1;
}

/// All that an item of one answer has in common.
struct Shared {
  Json insert;
  Json replace;
  std::string uri;
  const ClientFeatures& client;
};

Json textEdit(const ide::Completion& item, const Shared& shared) {
  const bool asSnippet = shared.client.snippets && !item.snippet.empty();
  const auto& text = asSnippet ? item.snippet : item.insert;
  if (shared.client.insertReplace)
    return {{"newText", text}, {"insert", shared.insert}, {"replace", shared.replace}};
  return {{"newText", text}, {"range", shared.insert}};
}

Json dataOf(const ide::Completion& item, const std::string& uri) {
  Json data{{"uri", uri}};
  if (item.symbol) data["symbol"] = toJson(*item.symbol);
  if (item.word) data["word"] = item.word - ide::vocabulary().data();
  return data;
}

Json itemJson(const ide::Completion& item, std::size_t place, const Shared& shared) {
  Json json{{"label", item.label},
            {"kind", kindOf(item.kind)},
            {"filterText", item.filter},
            {"sortText", fmt::format("{:04}", place)},
            {"textEdit", textEdit(item, shared)}};
  if (!item.detail.empty()) json["detail"] = item.detail;
  if (shared.client.snippets && !item.snippet.empty()) json["insertTextFormat"] = 2;
  if (item.symbol || item.word) json["data"] = dataOf(item, shared.uri);
  return json;
}

/// The character that was typed where that was what asked.
ide::CompletionTrigger triggerOf(const Json& params) {
  const auto& character = memberAt(params, {"context", "triggerCharacter"});
  const bool typed = memberAt(params, {"context", "triggerKind"}) == 2;
  if (!typed || !character.is_string() || character.get_ref<const std::string&>().size() != 1)
    return {};
  return {character.get_ref<const std::string&>().front()};
}

Answer completion(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const auto trigger = triggerOf(request.params);
  const auto found = ide::isFiacre(at->view)
                         ? ide::FiacreText(at->view.text()).complete(at->at, trigger)
                         : ide::complete(request.snapshot, at->view, at->at, trigger);
  const Converter convert(at->view, request);
  const Shared shared{convert.range(at->view.file, found.insert),
                      convert.range(at->view.file, found.replace), convert.uri(at->view.file),
                      request.client};
  Json items = Json::array();
  for (const auto& item : found.items) items.push_back(itemJson(item, items.size(), shared));
  return Json{{"isIncomplete", !found.isComplete}, {"items", std::move(items)}};
}

/// The item that `data` is of; one of which nothing is known has no documentation.
ide::Completion itemOf(const Json& data) {
  ide::Completion item;
  item.symbol = symbolKey(memberAt(data, {"symbol"}));
  const auto& word = memberAt(data, {"word"});
  const auto words = ide::vocabulary();
  if (word.is_number_unsigned() && word.get<std::size_t>() < words.size())
    item.word = &words[word.get<std::size_t>()];
  return item;
}

Answer resolve(const Request& request) {
  Json item = request.params;
  const auto& data = memberAt(request.params, {"data"});
  auto view = viewOfData(request, data);
  if (!view) return item;
  const auto text = ide::documentation(*view, itemOf(data));
  if (!text.empty()) item["documentation"] = markupContent(text, request.client.markdownCompletion);
  return item;
}

} // namespace

void addCompletion(Registry& registry) {
  registry.capabilities["completionProvider"] = {
      {"triggerCharacters", Json::array({"(", ":", ".", "$", " ", "\"", "/"})},
      {"resolveProvider", true}};
  registry.add("textDocument/completion", completion);
  registry.add("completionItem/resolve", resolve);
}

} // namespace proskill::lsp
