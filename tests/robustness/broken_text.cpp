#include "tests/robustness/broken_text.h"

#include "tests/support/random/random_source.h"
#include "tests/where.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace proskill::test {

std::vector<Example> examples() {
  const std::filesystem::path root = std::filesystem::path(PROSKILL_SOURCE_DIR) / "examples";
  std::vector<Example> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".proskill") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    all.push_back({entry.path().lexically_relative(root).string(), text.str()});
  }
  std::ranges::sort(all, {}, &Example::name);
  return all;
}

std::string repeated(const std::string& part, std::size_t times) {
  std::string text;
  text.reserve(part.size() * times);
  for (std::size_t i = 0; i < times; ++i) text += part;
  return text;
}

std::string randomBytes(std::uint64_t seed, std::size_t count) {
  RandomSource random(seed);
  std::string text(count, '\0');
  for (char& byte : text) byte = static_cast<char>(random.below(256));
  return text;
}

std::string randomWords(std::uint64_t seed, std::size_t count) {
  static const std::vector<std::string> words{"(",
                                              "(",
                                              "(",
                                              ")",
                                              ")",
                                              "\n(",
                                              "[",
                                              "]",
                                              "...",
                                              "\"",
                                              "\\",
                                              ";",
                                              "\n",
                                              "\r\n",
                                              " ",
                                              ":",
                                              ":body",
                                              ":effects",
                                              ":guard",
                                              ":success",
                                              ":init",
                                              ":states",
                                              ":within",
                                              "$x",
                                              "a.status",
                                              "a.",
                                              "^",
                                              "//",
                                              "~",
                                              "/=",
                                              "-",
                                              "1",
                                              "1.5",
                                              "99999999999999999999",
                                              "defskill",
                                              "defconst",
                                              "defsv",
                                              "defevent",
                                              "defproperty",
                                              "defresource",
                                              "defenvironment",
                                              "include",
                                              "if",
                                              "elseif",
                                              "else",
                                              "while",
                                              "do",
                                              "until",
                                              "goto",
                                              "label",
                                              "break",
                                              "printf",
                                              "always",
                                              "ltl",
                                              "[]",
                                              "<>",
                                              "()",
                                              "running",
                                              "true",
                                              "\xc3\xa9",
                                              "\xff",
                                              std::string(1, '\0')};
  RandomSource random(seed);
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += random.pick(words) + (random.chance(60) ? " " : "");
  return text;
}

std::vector<Broken> brokenTexts() {
  constexpr std::size_t kDeep = 100'000;
  std::string condition = repeated("(not ", kDeep) + "(a B)" + repeated(")", kDeep);
  std::string body = repeated("(if true ", kDeep) + "(s)" + repeated(")", kDeep);
  return {
      {"nothing", ""},
      {"100,000 opening parentheses", repeated("(", kDeep)},
      {"100,000 closing parentheses", repeated(")", kDeep)},
      {"100,000 nested parentheses", repeated("(", kDeep) + repeated(")", kDeep)},
      {"a condition 100,000 deep", "(defproperty p (always " + condition + "))"},
      {"a body 100,000 deep", "(defskill s :body (" + body + "))"},
      {"branches 100,000 deep",
       "(defskill s :body " + repeated("((// ", kDeep) + repeated("))", kDeep) + ")"},
      {"100,000 definitions of one name", repeated("(defevent e :effects (v A))\n", kDeep)},
      {"100,000 fields of one form", "(defsv v " + repeated(":init A ", kDeep) + ")"},
      {"a name of a million letters", "(defevent " + repeated("a", 1'000'000) + ")"},
      {"a number of a million digits",
       "(defsv v :init " + repeated("9", 1'000'000) + " :min 0 :max 1)"},
      {"a string without an end", "(include \"" + repeated("x", 100'000)},
      {"a comment without an end", ";" + repeated("x", 100'000)},
      {"NULs", std::string(10'000, '\0')},
      {"NULs within a form",
       "(defsv v" + std::string(3, '\0') + " :states (A" + std::string(1, '\0') + "B) :init A)"},
      {"no UTF-8", "(defsv \xff\xfe :states (\xc3\x28 \xf0\x28\x8c\x28) :init \xe2\x82)"},
      {"a half of a character at the end", "(defevent caf\xc3"},
      {"UTF-16", std::string("\xff\xfe(\0d\0e\0f\0", 10)},
      {"a mark of byte order alone", "\xef\xbb\xbf"},
      {"a mark of byte order, then a form", "\xef\xbb\xbf(defevent e :effects (v A))"},
      {"carriage returns alone", "(defevent e\r:effects (v A))\r"},
  };
}

} // namespace proskill::test
