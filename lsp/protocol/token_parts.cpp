#include "lsp/protocol/token_parts.h"

#include "ide/snapshot/fiacre_file.h"
#include "syntax/text/change.h"

#include <algorithm>
#include <span>

namespace proskill::lsp {

namespace {

using ide::Token;
using syntax::Offset;
using syntax::Range;

using Placed = std::span<const PlacedTokens>;

/// Whether these are the names of a part that now begins at `begin`.
bool areSame(std::span<const Token> names, const std::vector<Token>& known, Offset begin) {
  return std::ranges::equal(names, known, [begin](const Token& a, const Token& b) {
    return a == Token{{b.range.begin + begin, b.range.end + begin}, b.type, b.modifiers};
  });
}

/// \param line first line of the region
TokenPart partOf(const ide::View& view, const std::vector<Token>& tokens, std::uint32_t line,
                 syntax::Encoding encoding) {
  TokenPart part;
  part.numbers = encoded(view, tokens, encoding);
  if (tokens.empty()) return part;
  part.numbers[0] -= line;
  part.lastLine = view.document().lines().position(tokens.back().range.begin).line - line;
  return part;
}

/// Concatenates parts.
class Gathering {
public:
  Gathering(const ide::View& view, syntax::Encoding encoding, const TokenAnswer& earlier)
      : view(view), encoding(encoding), earlier(partsOf(earlier)) {}

  TokenAnswer ofRegions() {
    const auto all = ide::nameTokens(view, {0, static_cast<Offset>(view.text().size())});
    auto name = all.begin();
    for (const auto& region : view.document().regions()) {
      const auto first = name;
      name = std::find_if(name, all.end(),
                          [&](const Token& it) { return it.range.begin >= region.range.end; });
      const auto line = view.document().lines().position(region.range.begin, lineOfLast).line;
      place(part(region, {first, name}, line), line);
    }
    return std::move(answer);
  }

  TokenAnswer ofWhole() {
    place(std::make_shared<TokenPart>(partOf(view, ide::tokens(view), 0, encoding)), 0);
    return std::move(answer);
  }

private:
  static Parts<TokenPart> partsOf(const TokenAnswer& answer) {
    Parts<TokenPart> parts;
    for (const auto& it : answer) parts.push_back(it.part);
    return parts;
  }

  std::shared_ptr<const TokenPart> part(const syntax::Region& region, std::span<const Token> names,
                                        std::uint32_t line) {
    const auto begin = region.range.begin;
    if (auto known = earlier.find(region.tree); known && areSame(names, known->names, begin))
      return known;
    auto part = partOf(view, ide::tokens(view, region, names), line, encoding);
    part.tree = region.tree;
    for (auto name : names) {
      name.range = {name.range.begin - begin, name.range.end - begin};
      part.names.push_back(name);
    }
    return std::make_shared<const TokenPart>(std::move(part));
  }

  void place(std::shared_ptr<const TokenPart> part, std::uint32_t line) {
    const bool isEmpty = part->numbers.empty();
    const auto first = isEmpty ? 0 : line + part->numbers[0] - lineOfToken;
    if (!isEmpty) lineOfToken = line + part->lastLine;
    answer.push_back({std::move(part), first});
  }

  const ide::View& view;
  syntax::Encoding encoding;
  EarlierParts<TokenPart> earlier;
  TokenAnswer answer;
  std::uint32_t lineOfLast = 0;  ///< of the last region
  std::uint32_t lineOfToken = 0; ///< of the last token
};

std::size_t countOf(Placed placed) {
  std::size_t count = 0;
  for (const auto& it : placed) count += it.part->numbers.size();
  return count;
}

Numbers numbersOf(Placed placed) {
  Numbers numbers;
  numbers.reserve(countOf(placed));
  for (const auto& it : placed) {
    const auto begin = numbers.size();
    numbers.insert(numbers.end(), it.part->numbers.begin(), it.part->numbers.end());
    if (begin < numbers.size()) numbers[begin] = it.line;
  }
  return numbers;
}

void write(rpc::JsonWriter& json, std::span<const std::uint32_t> numbers) {
  json.open('[');
  for (auto number : numbers) json.value(number);
  json.close(']');
}

/// Writes the tokens between the common prefix and the common suffix.
/// \param start number of values before `before`
void writeEdit(rpc::JsonWriter& json, const Numbers& before, const Numbers& after,
               std::size_t start) {
  auto [head, tail] = syntax::commonEnds(before, after);
  head -= head % kNumbersPerToken;
  tail -= tail % kNumbersPerToken;
  if (head + tail == before.size() && head + tail == after.size()) return;
  json.open('{').member("start", start + head);
  json.member("deleteCount", before.size() - head - tail);
  write(json.key("data"), std::span(after).subspan(head, after.size() - head - tail));
  json.close('}');
}

} // namespace

Numbers encoded(const ide::View& view, const std::vector<Token>& tokens,
                syntax::Encoding encoding) {
  Numbers numbers;
  numbers.reserve(tokens.size() * kNumbersPerToken);
  syntax::EditorPosition last;
  syntax::LineWalk walk(view.text(), view.document().lines(), encoding);
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

TokenAnswer tokenAnswer(const ide::View& view, syntax::Encoding encoding,
                        const TokenAnswer& earlier) {
  Gathering gathering(view, encoding, earlier);
  return ide::isFiacre(view) ? gathering.ofWhole() : gathering.ofRegions();
}

std::string allTokens(const TokenAnswer& answer) {
  rpc::JsonWriter json;
  constexpr std::size_t kBytesPerNumber = 3;
  json.reserve(countOf(answer) * kBytesPerNumber);
  write(json, numbersOf(answer));
  return json.take();
}

std::string tokenEdits(const TokenAnswer& before, const TokenAnswer& after) {
  const auto [front, back] = syntax::commonEnds(before, after);
  const auto old = Placed(before).subspan(front, before.size() - front - back);
  const auto now = Placed(after).subspan(front, after.size() - front - back);
  auto start = countOf(Placed(before).first(front));
  rpc::JsonWriter json;
  json.open('[');
  if (old.size() != now.size()) {
    writeEdit(json, numbersOf(old), numbersOf(now), start);
  } else {
    for (std::size_t i = 0; i < old.size(); ++i) {
      const auto was = old.subspan(i, 1);
      if (old[i] != now[i]) writeEdit(json, numbersOf(was), numbersOf(now.subspan(i, 1)), start);
      start += countOf(was);
    }
  }
  return json.close(']').take();
}

} // namespace proskill::lsp
