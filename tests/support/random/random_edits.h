#pragma once

#include "tests/support/random/random_source.h"

#include "syntax/text/edit.h"

#include <array>
#include <string>
#include <string_view>

namespace proskill::test {

/// Random edits as people make them.
class RandomEdits {
public:
  explicit RandomEdits(std::uint64_t seed) : random(seed) {}

  /// Typing errors, and pieces of the text moved elsewhere.
  syntax::TextEdit slip(const std::string& text) {
    static constexpr std::array<std::string_view, 22> kSlips = {
        "(",    ")", "\"", ";", "\n",   "\n(defskill x",           "\n(defsv", "$", ":", ".",
        "[",    "]", "^",  "é", "\xff", std::string_view("\0", 1), "\r\n",     " ", "x", "1",
        "))))", "//"};
    auto begin = pick(text.size() + 1);
    auto end = std::min(text.size(), begin + (pick(3) == 0 ? pick(40) : pick(3)));
    std::string put;
    if (pick(4) == 0) {
      put = text.substr(pick(text.size() + 1), pick(60));
    } else if (pick(3) != 0) {
      put = kSlips[pick(kSlips.size())];
    }
    return edit(begin, end, put);
  }

  /// White space and comments at the end of a line; rarely a word that changes the program.
  syntax::TextEdit touch(const std::string& text) {
    static constexpr std::array<std::string_view, 8> kTouches = {
        " ", "\n", " ; note", "\n; note", "\n\n", " ; (not code", "\n  ; \"nor this", " x"};
    const auto at = std::min(text.find('\n', pick(text.size() + 1)), text.size());
    const auto comment = text.rfind(';', at);
    const auto line = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const bool hasComment =
        comment != std::string::npos && (line == std::string::npos || comment > line);
    if (hasComment && pick(3) == 0) return edit(comment, at, "");
    return edit(at, at, kTouches[pick(kTouches.size())]);
  }

  /// A letter of a word duplicated or removed, as in a name that is being typed.
  syntax::TextEdit misspell(const std::string& text) {
    static constexpr std::string_view kLetters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
    const auto at = text.find_first_of(kLetters, pick(text.size() + 1));
    if (at == std::string::npos) return edit(text.size(), text.size(), "x");
    return pick(2) == 0 ? edit(at, at, text.substr(at, 1)) : edit(at, at + 1, "");
  }

  /// Any of them.
  syntax::TextEdit any(const std::string& text) {
    switch (pick(3)) {
    case 0: return slip(text);
    case 1: return touch(text);
    default: return misspell(text);
    }
  }

  std::size_t pick(std::size_t bound) { return random.below(bound); }

private:
  static syntax::TextEdit edit(std::size_t begin, std::size_t end, std::string_view put) {
    return {{static_cast<syntax::Offset>(begin), static_cast<syntax::Offset>(end)},
            std::string(put)};
  }

  RandomSource random;
};

} // namespace proskill::test
