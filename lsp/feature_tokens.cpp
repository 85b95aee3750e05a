#include "ide/tokens.h"
#include "lsp/convert.h"

#include <algorithm>
#include <atomic>
#include <list>
#include <mutex>

namespace proskill::lsp {

namespace {

/// In the order of `ide::TokenType`.
constexpr std::array kTypes{"keyword",   "property", "comment",  "string",     "number",
                            "operator",  "function", "variable", "enumMember", "event",
                            "parameter", "type",     "resource", "interface",  "namespace",
                            "decorator", "label"};
/// In the order of the bits of `ide::TokenModifier`.
constexpr std::array kModifiers{"definition", "modification", "unused"};

using Numbers = std::vector<std::uint32_t>;
constexpr std::size_t kNumbersPerToken = 5;

/// Lines and columns as differences from the token before.
Numbers encoded(const ide::View& view, const std::vector<ide::Token>& tokens, Encoding encoding) {
  Numbers numbers;
  numbers.reserve(tokens.size() * kNumbersPerToken);
  EditorPosition last;
  LineWalk walk(view.text(), view.document().lines(), encoding);
  for (const auto& token : tokens) {
    auto begin = walk.to(token.range.begin);
    auto end = walk.to(token.range.end);
    bool sameLine = begin.line == last.line;
    numbers.insert(numbers.end(),
                   {begin.line - last.line, begin.character - (sameLine ? last.character : 0),
                    end.character - begin.character, static_cast<std::uint32_t>(token.type),
                    token.modifiers});
    last = begin;
  }
  return numbers;
}

/// The last answers, so that the next ones can be told as changes. Any thread may use it.
class LastAnswers {
public:
  struct Entry {
    std::string uri;
    std::string id;
    std::shared_ptr<const Numbers> numbers;
  };

  /// The answer of that identifier, null where it is no longer known.
  std::shared_ptr<const Numbers> find(const std::string& uri, const std::string& id) {
    const std::lock_guard lock(mutex);
    auto found = std::ranges::find_if(
        entries, [&](const Entry& entry) { return entry.uri == uri && entry.id == id; });
    return found == entries.end() ? nullptr : found->numbers;
  }

  /// Its identifier; of each text the last one is kept, and of few texts.
  std::string keep(const std::string& uri, std::shared_ptr<const Numbers> numbers) {
    const std::lock_guard lock(mutex);
    entries.remove_if([&](const Entry& entry) { return entry.uri == uri; });
    if (entries.size() >= kMost) entries.pop_back();
    entries.push_front({uri, std::to_string(++lastId), std::move(numbers)});
    return entries.front().id;
  }

private:
  static constexpr std::size_t kMost = 32;
  std::mutex mutex;
  std::list<Entry> entries; ///< the newest first
  std::uint64_t lastId = 0;
};

/// One edit: what is between the tokens that both begin with and those that both end with.
Json changes(const Numbers& before, const Numbers& after) {
  auto shortest = std::min(before.size(), after.size());
  auto head = static_cast<std::size_t>(std::ranges::mismatch(before, after).in1 - before.begin());
  head -= head % kNumbersPerToken;
  std::size_t tail = 0;
  while (tail < shortest - head &&
         before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
    ++tail;
  tail -= tail % kNumbersPerToken;
  if (head == before.size() && head == after.size()) return Json::array();
  return Json::array({{{"start", head},
                       {"deleteCount", before.size() - head - tail},
                       {"data", Numbers(after.begin() + static_cast<long>(head),
                                        after.end() - static_cast<long>(tail))}}});
}

std::string uriOf(const Request& request) { return request.params["textDocument"]["uri"]; }

Answer fullTokens(const Request& request, LastAnswers& last) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  auto numbers =
      std::make_shared<const Numbers>(encoded(*view, ide::tokens(*view), request.client.encoding));
  auto id = last.keep(uriOf(request), numbers);
  return Json{{"resultId", id}, {"data", *numbers}};
}

Answer changedTokens(const Request& request, LastAnswers& last) {
  auto known = request.params.find("previousResultId");
  if (known == request.params.end() || !known->is_string())
    return std::unexpected(RpcError{ErrorCode::InvalidParams, "`previousResultId` is missing"});
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  auto before = last.find(uriOf(request), *known);
  if (!before) return fullTokens(request, last);
  auto numbers =
      std::make_shared<const Numbers>(encoded(*view, ide::tokens(*view), request.client.encoding));
  auto edits = changes(*before, *numbers);
  return Json{{"resultId", last.keep(uriOf(request), numbers)}, {"edits", std::move(edits)}};
}

Answer rangeTokens(const Request& request) {
  auto view = documentView(request);
  if (!view) return std::unexpected(view.error());
  auto range = rangeIn(*view, request.params, request.client.encoding);
  if (!range) return std::unexpected(range.error());
  return Json{{"data", encoded(*view, ide::tokens(*view, *range), request.client.encoding)}};
}

} // namespace

void addTokens(Registry& registry) {
  auto last = std::make_shared<LastAnswers>();
  registry.add("textDocument/semanticTokens/full",
               [last](const Request& request) { return fullTokens(request, *last); });
  registry.add("textDocument/semanticTokens/full/delta",
               [last](const Request& request) { return changedTokens(request, *last); });
  registry.add("textDocument/semanticTokens/range", rangeTokens);
  registry.capabilities["semanticTokensProvider"] = {
      {"legend", {{"tokenTypes", kTypes}, {"tokenModifiers", kModifiers}}},
      {"range", true},
      {"full", {{"delta", true}}}};
}

} // namespace proskill::lsp
