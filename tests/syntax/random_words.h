#pragma once

#include "tests/support/random/random_source.h"

#include <array>
#include <string>
#include <string_view>

namespace proskill::test {

/// Pieces of programs in random order.
[[nodiscard]] inline std::string randomWords(RandomSource& random) {
  static constexpr std::array<std::string_view, 60> kWords = {
      "(",        ")",         "(defskill a",
      "(defsv",   ":init",     ":body ((",
      ":success", ":effects",  "(^",
      "(//",      "(if",       "else",
      "elseif",   "until",     "(do",
      "(while",   "[1,3]",     "[",
      "]",        "...",       ",",
      "$x",       "a",         "b.c",
      "a.",       "1",         "-2.5",
      "\"s\"",    "\"",        ";c\n",
      "\n",       "\n(defsv",  "=",
      "(=",       "(and",      "~",
      "([]",      "(()",       "(<>",
      "=>",       "(label",    "(success",
      "(set",     "break",     ":invariant",
      ":guard",   "true",      "é",
      "(leadsto", "(do-until", "(running",
      "(value",   ":within",   ":transitions :all",
      "(include", "a-b",       "\n(defproperty p (ltl",
      ")))",      "\\",        "\n(defenvironment e :body ("};
  std::string text;
  for (std::size_t count = random.below(60); count > 0; --count) {
    text += kWords[random.below(kWords.size())];
    if (random.chance(75)) text += ' ';
  }
  return text;
}

} // namespace proskill::test
