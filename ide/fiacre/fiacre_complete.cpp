#include "ide/fiacre/fiacre_text.h"

#include "fiacre/syntax/words.h"
#include "ide/fiacre/fiacre_names.h"

#include <algorithm>

namespace proskill::ide {

namespace {

using fiacre::Mention;
using fiacre::NameKind;
using fiacre::TokenKind;

/// The kind of name that must follow a word, if there is only one.
std::optional<NameKind> onlyBehind(std::string_view word) {
  if (word == "to" || word == "from" || word == "state") return NameKind::State;
  if (word == "assert" || word == "prove") return NameKind::Property;
  if (word == ".") return NameKind::Field;
  if (word == "tag" || word == "#") return NameKind::Tag;
  if (word == "start") return NameKind::Task;
  return std::nullopt;
}

/// Whether these words are followed by a new name.
bool declaresBehind(std::string_view word) {
  return word == "process" || word == "component" || word == "function" || word == "type" ||
         word == "const" || word == "channel" || word == "property" || word == "states" ||
         word == "var" || word == "port";
}

} // namespace

/// Whether a declared name is visible in a block. In a property, all states and tags are.
bool FiacreText::isKnownAt(Place declaration, const fiacre::Block* block) const {
  const auto& mention = mentions()[declaration];
  if (!isLocalName(mention.kind)) return true;
  if (!block || blocks[declaration] == block) return blocks[declaration] == block;
  return block->kind == NameKind::Property &&
         (mention.kind == NameKind::State || mention.kind == NameKind::Tag);
}

Completions FiacreText::complete(syntax::Offset at, CompletionTrigger trigger) const {
  auto word = std::ranges::find_if(words, [&](const fiacre::Token& each) {
    return at <= each.end() || each.kind == TokenKind::End;
  });
  Completions result{.insert = {at, at}, .replace = {at, at}};
  const bool within = word->kind != TokenKind::End && word->begin < at;
  const bool inComment = word->kind == TokenKind::Comment && within &&
                         (at < word->end() || word->text.starts_with("//"));
  if (inComment || (word->kind == TokenKind::String && within) ||
      (within && word->kind == TokenKind::Number))
    return result;
  if (word->kind == TokenKind::Name && word->begin <= at) {
    result.insert.begin = result.replace.begin = word->begin;
    result.replace.end = word->end();
  } else if (within) {
    ++word;
  }
  std::string_view before;
  while (word != words.begin() && before.empty())
    if ((--word)->kind != TokenKind::Comment) before = word->text;
  if (declaresBehind(before)) return result;
  const auto only = onlyBehind(before);
  if (trigger.typed && !only) return result;
  const auto block =
      std::ranges::upper_bound(parsed.blocks, result.insert.begin, {}, &fiacre::Block::begin);
  const auto* here = block == parsed.blocks.begin() ? nullptr : &block[-1];
  for (const auto& [name, places] : byName)
    for (const auto place : places) {
      const auto kind = mentions()[place].kind;
      // the word being typed is not a declared name
      const bool typed = mentions()[place].begin == result.insert.begin;
      if (typed || (only && kind != *only) || !isKnownAt(place, here)) continue;
      result.items.push_back({.label = std::string(name),
                              .kind = lookOf(kind).completion,
                              .insert = std::string(name),
                              .filter = std::string(name),
                              .rank = isLocalName(kind) ? 0U : 1U});
      break;
    }
  if (!only)
    for (const auto reserved : fiacre::reservedWords())
      result.items.push_back({.label = std::string(reserved),
                              .kind = CompletionKind::Keyword,
                              .insert = std::string(reserved),
                              .filter = std::string(reserved),
                              .rank = 2});
  std::ranges::stable_sort(result.items, {}, &Completion::rank);
  return result;
}

} // namespace proskill::ide
