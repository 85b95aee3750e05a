#include "ide/completion/completion.h"
#include "ide/fiacre/fiacre_text.h"
#include "ide/snapshot/fiacre_file.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/markup.h"
#include "lsp/protocol/numbers.h"
#include "lsp/protocol/symbol_json.h"
#include "syntax/text/characters.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace proskill::lsp {

namespace {

using ide::CompletionKind;

/// The protocol's `CompletionItemKind`.
protocol::CompletionItemKind kindOf(CompletionKind kind) {
  using enum protocol::CompletionItemKind;
  switch (kind) {
  case CompletionKind::Keyword:
  case CompletionKind::Statement: return Keyword;
  case CompletionKind::Field: return Property;
  case CompletionKind::Operator: return Operator;
  case CompletionKind::Variable:
  case CompletionKind::Parameter: return Variable;
  case CompletionKind::Value: return EnumMember;
  case CompletionKind::Skill: return Function;
  case CompletionKind::Event: return Event;
  case CompletionKind::Resource: return Class;
  case CompletionKind::Tag: return Constant;
  case CompletionKind::Label: return Reference;
  case CompletionKind::Type: return TypeParameter;
  case CompletionKind::File: return File;
  }
  return Text;
}

/// What all items of an answer share.
struct Shared {
  std::string insert; ///< ranges, as JSON
  std::string replace;
  std::string uri;
  std::size_t column = 0; ///< where what is inserted begins in its line
  const ClientFeatures& client;
};

bool isSnippet(const ide::Completion& item, const Shared& shared) {
  return shared.client.snippets && !item.snippet.empty();
}

/// Whether its lines keep the indentation that they have here.
bool isAsIs(const ide::Completion& item, const Shared& shared) {
  return shared.client.insertTextModes && isSnippet(item, shared) && item.snippet.contains('\n');
}

/// The snippet, whose lines are indented from the `(` of its form.
std::string snippetOf(const ide::Completion& item, const Shared& shared) {
  if (!isAsIs(item, shared)) return item.snippet;
  const std::size_t before = item.snippet.starts_with('(') ? 0 : 1;
  const std::string indent(shared.column - std::min(shared.column, before), ' ');
  std::string text;
  for (const char c : item.snippet) {
    text += c;
    if (c == '\n') text += indent;
  }
  return text;
}

void writeEdit(rpc::JsonWriter& json, const ide::Completion& item, const Shared& shared) {
  json.key("textEdit").open('{');
  json.member("newText", isSnippet(item, shared) ? snippetOf(item, shared) : item.insert);
  if (shared.client.insertReplace)
    json.key("insert").written(shared.insert).key("replace").written(shared.replace);
  else
    json.key("range").written(shared.insert);
  json.close('}');
}

void writeData(rpc::JsonWriter& json, const ide::Completion& item, const std::string& uri) {
  json.key("data").open('{').member("uri", uri);
  if (item.symbol) write(json.key("symbol"), *item.symbol);
  if (item.word) json.member("word", item.word - ide::vocabulary().data());
  json.close('}');
}

Json itemJson(const ide::Completion& item, std::size_t place, const Shared& shared) {
  rpc::JsonWriter json;
  json.open('{').member("label", item.label).member("kind", kindOf(item.kind));
  json.member("filterText", item.filter).member("sortText", fmt::format("{:04}", place));
  writeEdit(json, item, shared);
  if (!item.detail.empty()) json.member("detail", item.detail);
  if (isSnippet(item, shared)) json.member("insertTextFormat", protocol::InsertTextFormat::Snippet);
  // the indentation is that of the formatter, whatever the line's
  if (isAsIs(item, shared)) json.member("insertTextMode", protocol::InsertTextMode::AsIs);
  if (item.isDeprecated && shared.client.completionTags)
    json.key("tags").open('[').value(protocol::CompletionItemTag::Deprecated).close(']');
  else if (item.isDeprecated && shared.client.completionDeprecated)
    json.member("deprecated", true);
  if (item.symbol || item.word) writeData(json, item, shared.uri);
  return rpc::written(json.close('}').str());
}

/// The typed character that triggered the request, if any.
ide::CompletionTrigger triggerOf(const Json& params) {
  const auto& character = rpc::memberAt(params, {"context", "triggerCharacter"});
  const bool typed = rpc::memberAt(params, {"context", "triggerKind"}) == 2;
  if (!typed || !character.is_string() || character.get_ref<const std::string&>().size() != 1)
    return {};
  return {character.get_ref<const std::string&>().front()};
}

/// The width of a line before an offset.
std::size_t columnOf(std::string_view text, syntax::Offset at) {
  const auto before = text.substr(0, at);
  return syntax::widthOf(before.substr(before.rfind('\n') + 1));
}

Answer completion(const Request& request) {
  auto at = cursor(request);
  if (!at) return std::unexpected(at.error());
  const auto trigger = triggerOf(request.params);
  const auto found = ide::isFiacre(at->view)
                         ? ide::FiacreText(at->view.text()).complete(at->at, trigger)
                         : ide::complete(request.snapshot, at->view, at->at, trigger);
  const Converter convert(at->view, request);
  auto rangeText = [&](syntax::Range range) {
    rpc::JsonWriter json;
    convert.write(json, at->view.file, range);
    return json.take();
  };
  const Shared shared{rangeText(found.insert), rangeText(found.replace), convert.uri(at->view.file),
                      columnOf(at->view.text(), found.insert.begin), request.client};
  Json items = Json::array();
  for (const auto& item : found.items) items.push_back(itemJson(item, items.size(), shared));
  return Json{{"isIncomplete", !found.isComplete}, {"items", std::move(items)}};
}

/// The item that `data` identifies; an unknown one has no documentation.
ide::Completion itemOf(const Json& data) {
  ide::Completion item;
  item.symbol = symbolKey(rpc::memberAt(data, {"symbol"}));
  const auto& word = rpc::memberAt(data, {"word"});
  const auto words = ide::vocabulary();
  if (word.is_number_unsigned() && word.get<std::size_t>() < words.size())
    item.word = &words[word.get<std::size_t>()];
  return item;
}

Answer resolveCompletion(const Request& request) {
  Json item = request.params;
  const auto& data = rpc::memberAt(request.params, {"data"});
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
  registry.add("completionItem/resolve", resolveCompletion);
}

} // namespace proskill::lsp
