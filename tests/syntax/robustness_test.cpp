#include "tests/support/sanitized.h"
#include "tests/syntax/programs.h"
#include "tests/syntax/random_words.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::Document;
using syntax::Offset;
using namespace std::string_literals;

namespace {

std::string repeated(std::string_view piece, std::size_t times) {
  std::string text;
  text.reserve(piece.size() * times);
  for (std::size_t i = 0; i < times; ++i) text += piece;
  return text;
}

bool inside(const Document& document, syntax::Range range) {
  return range.begin <= range.end && range.end <= document.text().size();
}

/// Invariants of every document, whatever its text.
bool isSound(const Document& document) {
  for (const auto& form : document.forms())
    if (!inside(document, form.range)) return false;
  for (auto comment : document.comments())
    if (document.text().at(comment.begin) != ';') return false;
  for (const auto& diagnostic : document.diagnostics())
    if (!inside(document, diagnostic.location.range)) return false;
  // the grammar accepts every text; an ERROR would be a gap in it
  return document.dump().find("ERROR") == std::string::npos;
}

} // namespace

TEST_CASE("every prefix of every program gives a tree") {
  for (const auto& program : test::allPrograms()) {
    auto document = Document::parse(program);
    for (auto end = static_cast<Offset>(program.size()); end > 0;) {
      const Offset begin = end - std::min<Offset>(end, test::kSanitized ? 3 : 1);
      document = document.edit({begin, end}, "");
      end = begin;
      CHECK(isSound(document));
    }
  }
}

TEST_CASE("every program without one of its lines gives a tree") {
  for (const auto& program : test::allPrograms()) {
    syntax::LineIndex lines(program);
    for (std::uint32_t line = 0; line + 1 < lines.lineCount(); ++line) {
      auto text = program;
      auto begin = lines.offset({line, 0});
      text.erase(begin, lines.offset({line + 1, 0}) - begin);
      CHECK(isSound(Document::parse(text)));
    }
  }
}

TEST_CASE("the paper's program without any one of its characters gives a tree") {
  auto whole = Document::parse(test::paperProgram());
  for (syntax::Offset at = 0; at < whole.text().size(); ++at) {
    INFO("without character " << at);
    CHECK(isSound(whole.edit({at, at + 1}, "")));
  }
}

TEST_CASE("empty parentheses and comments may stand anywhere") {
  auto whole = Document::parse(test::paperProgram());
  for (syntax::Offset at = 0; at < whole.text().size(); ++at) {
    if (whole.text()[at] != '(' && whole.text()[at] != ' ') continue;
    INFO("after character " << at);
    CHECK(isSound(whole.edit({at + 1, at + 1}, "() ")));
    CHECK(isSound(whole.edit({at + 1, at + 1}, "(; nothing\n) ")));
    bool inComment = std::ranges::any_of(
        whole.comments(), [&](syntax::Range comment) { return comment.contains(at); });
    auto line = whole.lines().line(whole.lines().position(at).line, whole.text());
    bool inString = whole.text().substr(line.begin, at - line.begin).contains('"');
    if (inComment || inString) continue;
    auto commented = whole.edit({at + 1, at + 1}, "; a note\n ");
    CHECK(test::codesOf(commented) == "");
  }
}

TEST_CASE("random bytes give a tree and diagnostics") {
  test::RandomSource random(7);
  for (int i = 0; i < 300; ++i) {
    std::string text;
    for (std::size_t n = random.below(400); n > 0; --n)
      text += static_cast<char>(random.below(256));
    CHECK(isSound(Document::parse(text)));
  }
}

TEST_CASE("random words give a tree and diagnostics") {
  test::RandomSource random(11);
  for (int i = 0; i < 3000; ++i) {
    auto text = test::randomWords(random);
    INFO(text);
    CHECK(isSound(Document::parse(text)));
  }
}

TEST_CASE("a hundred thousand nested parentheses are one diagnostic") {
  for (const auto& text : {repeated("(", 100'000), repeated("(", 100'000) + repeated(")", 100'000),
                           "(defskill a :body " + repeated("((if (a b) ", 50'000)}) {
    auto document = Document::parse(text);
    CHECK(isSound(document));
    CHECK(test::codesOf(document) == "PS0005");
    REQUIRE(document.forms().size() == 1);
  }
}

TEST_CASE("a hundred thousand closing parentheses are few diagnostics") {
  auto document = Document::parse(repeated(")", 100'000));
  CHECK(isSound(document));
  CHECK(document.diagnostics().size() <= 16);
}

TEST_CASE("what is nested too deep does not hide its neighbours") {
  auto document = Document::parse("(defsv a :init 1 :min 0 :max 2)\n" + repeated("(", 300) +
                                  "\n(defevent gust :effects (a 2))\n");
  // both are in one region of text, up to the next definition
  CHECK(test::codesOf(document) == "PS0005");
  CHECK(document.forms().back().is<syntax::Event>());
}

TEST_CASE("a hundred megabytes in one line are one diagnostic") {
  auto document = Document::parse(repeated("a b (c) ", 100'000'000 / 8));
  CHECK(test::codesOf(document) == "PS0003");
  CHECK(document.forms().size() == 1);
  CHECK(test::codesOf(Document::parse(repeated("a b (c) ", 300'000))) == "PS0004");
}

TEST_CASE("a text that is too long is kept, and read when it has become shorter") {
  const std::string line = "(defsv a :init 1 :min 0 :max 2)\n";
  const std::string text = repeated(line, 17'000'000 / line.size());
  const auto document = Document::parse(text);
  CHECK(test::codesOf(document) == "PS0003");
  CHECK(document.text() == text);
  CHECK(document.edit({5, 5}, "x").text().size() == text.size() + 1);
  const auto shorter =
      document.edit({static_cast<Offset>(2 * line.size()), static_cast<Offset>(text.size())}, "");
  CHECK(shorter.forms().size() == 2);
  CHECK(shorter.dump() == Document::parse(line + line).dump());
}

TEST_CASE("a hundred thousand comments in a row are read") {
  auto document =
      Document::parse(repeated("; note\n", 100'000) + "(defsv a :init 1 :min 0 :max 2)");
  CHECK(isSound(document));
  CHECK(document.comments().size() == 100'000);
  auto within = Document::parse("(defskill s\n" + repeated(";\n", 100'000) + ":body ((x)))");
  CHECK(isSound(within));
  CHECK(std::get<syntax::Skill>(within.forms().at(0).node()).body->statements.size() == 1);
}

TEST_CASE("a definition of half a megabyte is read") {
  auto document = Document::parse("(defskill a\n  :body (" +
                                  repeated("(takeoff height 3.0)\n", 25'000) + "))\n");
  CHECK(test::codesOf(document) == "");
  CHECK(std::get<syntax::Skill>(document.forms().at(0).node()).body->statements.size() == 25'000);
}

TEST_CASE("bytes that are no UTF-8 are named with their place, and the rest is read") {
  auto document = Document::parse("; \xc3\xa9 is fine, \xe9\xe8 is not\n"
                                  "(defsv a :init 1 :min 0 :max 2)\n");
  REQUIRE(test::codesOf(document) == "PS0001");
  CHECK(document.diagnostics()[0].location.range == syntax::Range{14, 16});
  CHECK(document.forms().size() == 1);
}

TEST_CASE("overlong and surrogate sequences are no UTF-8") {
  for (std::string bytes : {"\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82", "\x80"})
    CHECK(test::codesOf(Document::parse("; " + bytes + "\n")) == "PS0001");
  for (std::string bytes : {"\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x9a\x81"})
    CHECK(test::codesOf(Document::parse("; " + bytes + "\n")) == "");
}

TEST_CASE("control characters are named") {
  auto document = Document::parse("(defsv a :init 1\0 :min 0 :max 2)"s);
  REQUIRE(test::codesOf(document) == "PS0002");
  CHECK(document.diagnostics()[0].message ==
        "control character (U+0000) is not allowed in a program");
}

TEST_CASE("a byte order mark and the line ends of other systems are tolerated") {
  auto document =
      Document::parse("\xef\xbb\xbf(defsv a :init 1\r\n  :min 0 ; low\r\n  :max 2)\r\n");
  CHECK(test::codesOf(document) == "");
  REQUIRE(document.forms().size() == 1);
  auto comment = document.comments().at(0);
  CHECK(document.text().substr(comment.begin, comment.length()) == "; low");
}

TEST_CASE("an empty text is a document without forms") {
  auto document = Document::parse("");
  CHECK(document.forms().empty());
  CHECK(document.diagnostics().empty());
  CHECK(document.edit({0, 0}, "(defsv a :init 1 :min 0 :max 2)").forms().size() == 1);
}
