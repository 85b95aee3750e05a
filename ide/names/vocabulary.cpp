#include "ide/names/vocabulary.h"

#include <algorithm>

namespace proskill::ide {

namespace {

constexpr Word kWords[] = {
#define WORD(kind, word, form, snippet, sentence) {WordKind::kind, word, form, snippet, sentence},
#include "ide/names/vocabulary.def"
#undef WORD
};

} // namespace

std::span<const Word> vocabulary() { return kWords; }

std::span<const Word> wordsOf(WordKind kind) {
  auto isOther = [kind](const Word& word) { return word.kind != kind; };
  const auto* first = std::ranges::find(kWords, kind, &Word::kind);
  const auto* last =
      std::find_if(first, std::end(kWords), [&](const Word& word) { return isOther(word); });
  return {first, last};
}

const Word* findWord(WordKind kind, std::string_view text) {
  auto words = wordsOf(kind);
  auto found = std::ranges::find(words, text, &Word::text);
  return found == words.end() ? nullptr : &*found;
}

} // namespace proskill::ide
