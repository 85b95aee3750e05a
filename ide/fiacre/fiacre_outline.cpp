#include "ide/fiacre/fiacre_text.h"

#include "fiacre/syntax/words.h"
#include "ide/answers/fold.h"
#include "ide/fiacre/fiacre_names.h"

#include <algorithm>

namespace proskill::ide {

namespace {

using fiacre::Mention;
using fiacre::NameKind;
using fiacre::TokenKind;

/// Whether it is shown as a part of a process or type.
bool isPart(NameKind kind) {
  return kind == NameKind::State || kind == NameKind::Variable || kind == NameKind::Port ||
         kind == NameKind::Parameter || kind == NameKind::Field || kind == NameKind::Constructor;
}

std::optional<TokenType> typeOf(const fiacre::Token& token) {
  switch (token.kind) {
  case TokenKind::Comment: return TokenType::Comment;
  case TokenKind::String: return TokenType::String;
  case TokenKind::Number: return TokenType::Number;
  case TokenKind::Symbol: return TokenType::Operator;
  case TokenKind::Name:
    return fiacre::isReserved(token.text) ? std::optional(TokenType::Keyword) : std::nullopt;
  case TokenKind::End: return std::nullopt;
  }
  return std::nullopt;
}

/// Adds a token for each line of a comment.
void addLines(std::vector<Token>& tokens, const fiacre::Token& word, TokenType type) {
  for (std::size_t begin = 0; begin < word.text.size();) {
    const auto end = std::min(word.text.find_first_of("\r\n", begin), word.text.size());
    const auto from = word.begin + static_cast<syntax::Offset>(begin);
    if (end > begin)
      tokens.push_back({{from, word.begin + static_cast<syntax::Offset>(end)}, type, 0});
    begin = end + 1;
  }
}

bool opens(std::string_view word) {
  return word == "select" || word == "if" || word == "case" || word == "while" ||
         word == "foreach" || word == "par" || word == "begin" || word == "record" ||
         word == "union";
}

} // namespace

std::vector<FiacreEntry> FiacreText::outline() const {
  std::vector<FiacreEntry> result;
  const fiacre::Block* last = nullptr;
  for (Place i = 0; i < mentions().size(); ++i) {
    const auto& mention = mentions()[i];
    const auto* block = blocks[i];
    if (!mention.declares || !block) continue;
    const syntax::Range name{mention.begin, mention.end};
    FiacreEntry entry{.name = std::string(nameOf(mention)),
                      .kind = mention.kind,
                      .range = name,
                      .selection = name};
    if (isPart(mention.kind)) {
      if (block == last && !result.empty()) result.back().children.push_back(std::move(entry));
    } else if (mention.kind != NameKind::Tag) {
      if (block != last) entry.range = {block->begin, block->end};
      result.push_back(std::move(entry));
      last = block;
    }
  }
  return result;
}

std::vector<Token> FiacreText::tokens() const {
  std::vector<Token> result;
  auto mention = mentions().begin();
  for (const auto& word : words) {
    while (mention != mentions().end() && mention->begin < word.begin) ++mention;
    if (mention != mentions().end() && mention->begin == word.begin) {
      const auto place = static_cast<Place>(mention - mentions().begin());
      const auto declaration = declarations[place];
      const auto kind = declaration == kNowhere ? mention->kind : mentions()[declaration].kind;
      const auto modifiers = static_cast<std::uint8_t>(declaration == place ? kDefinition : 0);
      result.push_back({{word.begin, word.end()}, lookOf(kind).token, modifiers});
    } else if (const auto type = typeOf(word)) {
      addLines(result, word, *type);
    }
  }
  return result;
}

std::vector<Fold> FiacreText::folds() const {
  const syntax::LineIndex lines(text);
  FoldList folds(lines);
  for (const auto& block : parsed.blocks) folds.add({block.begin, block.end});
  std::vector<std::uint32_t> open;
  std::optional<std::uint32_t> from;
  std::uint32_t end = 0;
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (word->kind == TokenKind::Comment) {
      auto next = word;
      while (next[1].kind == TokenKind::Comment &&
             lines.position(next[1].begin).line == lines.position(next->end()).line + 1)
        ++next;
      folds.add({word->begin, next->end()}, FoldKind::Comment);
      word = next;
      continue;
    }
    const bool startsAnew =
        word->kind == TokenKind::End || word->text == "from" ||
        std::ranges::binary_search(parsed.blocks, word->begin, {}, &fiacre::Block::begin);
    if (startsAnew && from) folds.add({*from, end});
    if (startsAnew) {
      from = word->text == "from" ? std::optional(word->begin) : std::nullopt;
      open.clear();
    }
    const bool afterEnd = word != words.begin() && word[-1].text == "end";
    if (word->kind == TokenKind::Name && opens(word->text) && !afterEnd)
      open.push_back(word->begin);
    end = word->end();
    if (word->kind == TokenKind::Name && word->text == "end" && !open.empty()) {
      folds.add({open.back(), end});
      open.pop_back();
    }
  }
  return folds.take();
}

} // namespace proskill::ide
