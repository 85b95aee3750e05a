#include "syntax/diagnostics/codes.h"
#include "tests/analysis/findings.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cctype>
#include <set>

using namespace proskill;

namespace {

/// Those that no text of a sensible size raises have tests of their own.
bool needsMoreThanAText(syntax::Code code) {
  return code == syntax::Code::TextTooLong || code == syntax::Code::FormTooLarge ||
         code == syntax::Code::NestedTooDeep || code == syntax::Code::IncludeCycle;
}

/// From `PS0200` on: static errors.
bool isAboutMeaning(const syntax::CodeInfo& code) {
  return code.id >= "PS0200" && code.id < test::kFirstOfFlow;
}

bool isInWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The words of a text without keywords and duplicates.
std::set<std::string> wordsIn(std::string_view text) {
  std::set<std::string> result;
  for (auto at = std::ranges::find_if(text, isInWord); at != text.end();) {
    const auto end = std::find_if_not(at, text.end(), isInWord);
    const bool isKeyword = at != text.begin() && *std::prev(at) == ':';
    if (!isKeyword) result.emplace(at, end);
    at = std::find_if(end, text.end(), isInWord);
  }
  return result;
}

/// The text with `more` after each occurrence of a word.
std::string withLonger(std::string_view text, std::string_view word, std::string_view more) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto after = i + word.size();
    const bool isIt = text.substr(i).starts_with(word) && (i == 0 || !isInWord(text[i - 1])) &&
                      (after == text.size() || !isInWord(text[after]));
    result += text[i];
    if (!isIt) continue;
    result.append(word.substr(1)).append(more);
    i = after - 1;
  }
  return result;
}

/// Everything that users read.
std::vector<std::string> wordsOf(const syntax::Diagnostic& diagnostic) {
  std::vector<std::string> result{diagnostic.message};
  for (const auto& related : diagnostic.related) result.push_back(related.message);
  for (const auto& fix : diagnostic.fixes) result.push_back(fix.title);
  return result;
}

} // namespace

TEST_CASE("each code is raised by its example") {
  for (const syntax::CodeInfo& code : syntax::allCodes()) {
    if (code.id >= test::kFirstOfFlow) continue;
    INFO(code.id);
    CHECK(code.example.empty() == needsMoreThanAText(code.code));
    if (code.example.empty()) continue;
    const auto found = test::diagnose(std::string(code.example));
    CHECK(std::ranges::count(found, code.code, &syntax::Diagnostic::code) > 0);
  }
}

TEST_CASE("the example of a code about meaning has no other mistake") {
  for (const syntax::CodeInfo& code : syntax::allCodes()) {
    if (!isAboutMeaning(code)) continue;
    INFO(code.id);
    const auto found = test::diagnose(std::string(code.example));
    REQUIRE(found.size() == 1);
    CHECK(found[0].severity == code.severity);
  }
}

TEST_CASE("an include cycle is told where it closes, with the way there") {
  const test::MemoryFiles files(
      {{"a.proskill", "(include \"b.proskill\")"}, {"b.proskill", "(include \"a.proskill\")"}});
  const auto found = analysis::check(analysis::load(files, "a.proskill"));
  REQUIRE(found.size() == 1);
  CHECK(found[0].code == syntax::Code::IncludeCycle);
  CHECK(found[0].location.file == 1);
  REQUIRE(found[0].related.size() == 1);
  CHECK(found[0].related[0].location.file == 0);
}

TEST_CASE("a word of any length is quoted in a message that can be read") {
  const std::string endless(1 << 16, 'x');
  for (const syntax::CodeInfo& code : syntax::allCodes()) {
    if (code.id >= test::kFirstOfFlow || code.example.empty()) continue;
    for (const auto& word : wordsIn(code.example)) {
      INFO(code.id << " with a long " << word);
      for (const auto& it : test::diagnose(withLonger(code.example, word, endless)))
        for (const auto& words : wordsOf(it)) CHECK(words.size() < 2000);
    }
  }
}

TEST_CASE("codes are unique, have their form, and explain themselves") {
  std::set<std::string_view> seen;
  for (const syntax::CodeInfo& code : syntax::allCodes()) {
    INFO(code.id);
    CHECK(code.id.size() == 6);
    CHECK(code.id.starts_with("PS"));
    CHECK(seen.insert(code.id).second);
    CHECK(code.explanation.size() > 40);
    CHECK(syntax::findCode(code.id)->code == code.code);
  }
}
