#include "syntax/format/format.h"
#include "tests/support/marked_source.h"
#include "tests/support/random/random_program.h"
#include "tests/support/sanitized.h"
#include "tests/syntax/programs.h"
#include "tests/syntax/random_words.h"

#include <array>
#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;
using syntax::Document;

namespace {

std::string formatted(const std::string& text) {
  auto document = Document::parse(text);
  auto result = syntax::applyEdits(text, syntax::format(document));
  auto again = Document::parse(result);
  INFO(text << "\n--- became\n" << result);
  CHECK(syntax::sameTokens(document, again));
  CHECK(syntax::format(again).empty());
  return result;
}

/// Other white space between the tokens; line ends are kept, since users may choose some of them.
std::string damaged(const std::string& text, test::RandomSource& random) {
  std::string result;
  bool quoted = false;
  for (std::size_t at = 0; at < text.size();) {
    char c = text[at];
    if (c == ';' && !quoted) {
      auto end = std::min(text.find('\n', at), text.size());
      result += text.substr(at, end - at);
      at = end;
      continue;
    }
    if (c == '"' && (at == 0 || text[at - 1] != '\\')) quoted = !quoted;
    if (quoted || (c != ' ' && c != '\n')) {
      result += c;
      ++at;
      continue;
    }
    auto end = std::min(text.find_first_not_of(" \n", at), text.size());
    auto gap = text.substr(at, end - at);
    auto lines = std::ranges::count(gap, '\n');
    for (long i = 0; i < lines; ++i) result += random.chance(20) ? " \t\n" : "\n";
    result += std::string(lines == 0 ? 1 : 0, ' ') + std::string(random.below(12), ' ');
    at = end;
  }
  return result;
}

} // namespace

TEST_CASE("the examples are laid out as the formatter lays them out") {
  for (const auto& program : test::allPrograms()) {
    if (program == test::paperProgram()) continue;
    CHECK(formatted(program) == program);
  }
}

TEST_CASE("what is wrong with the white space of a program is fixed") {
  test::RandomSource random(5);
  for (const auto& program : test::allPrograms()) {
    if (program == test::paperProgram()) continue;
    for (int i = 0; i < 20; ++i) CHECK(formatted(damaged(program, random)) == program);
  }
}

TEST_CASE("random programs keep their tokens, and are laid out once and for all") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    auto text = formatted(test::textOf(test::randomProgram(seed)));
    test::RandomSource random(seed);
    CHECK(formatted(damaged(text, random)) == text);
  }
}

TEST_CASE("random words keep their tokens, and are laid out once and for all") {
  test::RandomSource random(17);
  for (int i = 0; i < (test::kSanitized ? 1500 : 5000); ++i) formatted(test::randomWords(random));
}

TEST_CASE("lines are narrow enough wherever they can be broken") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    auto text = formatted(test::textOf(test::randomProgram(seed)));
    syntax::LineIndex lines(text);
    for (std::uint32_t line = 0; line < lines.lineCount(); ++line) {
      auto range = lines.line(line, text);
      INFO(text.substr(range.begin, range.length()));
      CHECK(range.length() <= syntax::kLineWidth);
    }
  }
}

TEST_CASE("the parts of a skill") {
  CHECK(formatted(R"((defskill   takeoff :input ( $height float
    $duration float )
:precondition (a (motion Free) b (on Ground))
   :start ( motion  Controlled ):invariant (in_control (:guard (motion Controlled))
 battery (:guard (~ (battery Critical)) :effects (motion Free)))
 :time_interval [ 1 , ...[ :action (takeoff $height)
 :success at_altitude (:effects (motion Free) :postcondition (flight InAir)) :failure (x y)
 ))") == R"((defskill takeoff
  :input ($height float
          $duration float)
  :precondition (a (motion Free)
                 b (on Ground))
  :start (motion Controlled)
  :invariant (in_control (:guard (motion Controlled))
              battery (:guard (~ (battery Critical))
                       :effects (motion Free)))
  :time_interval [1,...[
  :action (takeoff $height)
  :success at_altitude (:effects (motion Free)
                        :postcondition (flight InAir))
  :failure (x y))
)");
}

TEST_CASE("what is too long is broken where it can be") {
  CHECK(formatted("(defproperty always_seen (leadsto (and (battery Critical) (flight_status InAir) "
                  "(camera On) (target Found)) (running landing) :within [0,1]))\n") ==
        R"((defproperty always_seen
  (leadsto (and (battery Critical) (flight_status InAir) (camera On) (target Found))
           (running landing)
           :within [0,1]))
)");
}

TEST_CASE("comments stay where they are") {
  CHECK(formatted(R"(;; head
(defskill m ; the mission
   ; what it does
 :body ((if (a B) ; why
 (f)
    ; nothing more
   ; otherwise
   else (g) ; at last
   ) ; all done
   ; the end
   ))
; foot)") == R"(;; head
(defskill m ; the mission
  ; what it does
  :body
    ((if (a B) ; why
        (f)
        ; nothing more
      ; otherwise
      else
        (g) ; at last
        ) ; all done
     ; the end
     ))
; foot
)");
}

TEST_CASE("a definition that cannot be read stays as it is, and the others do not") {
  CHECK(formatted("(defsv  a :init  1 :max 2\n(defsv  b   :init 1 :max 2)\n") ==
        "(defsv  a :init  1 :max 2\n(defsv b :init 1 :max 2)\n");
  CHECK(formatted("(defsv  take-off :init  1)\n\n\n\n(defevent  e)") ==
        "(defsv  take-off :init  1)\n\n\n\n(defevent e)\n");
}

TEST_CASE("the ends of lines, and of the text") {
  CHECK(formatted("") == "");
  CHECK(formatted(" \n\n") == "");
  CHECK(formatted("(defevent e)") == "(defevent e)\n");
  CHECK(formatted("\n\n(defevent e)\n\n\n\n(defevent f)\n\n") == "(defevent e)\n\n(defevent f)\n");
  CHECK(formatted("(defevent e)\t\r\n;c \r\n(defevent f\r\n:effects (a B))") ==
        "(defevent e)\r\n;c\r\n(defevent f\r\n  :effects (a B))\r\n");
  CHECK(formatted("\xef\xbb\xbf\n (defevent e)") == "\xef\xbb\xbf(defevent e)\n");
}

TEST_CASE("an edit is as small as it can be") {
  auto document = Document::parse("(defevent e\n    :effects (a B))\n");
  CHECK(syntax::format(document) == std::vector<syntax::TextEdit>{{{14, 16}, ""}});
}

TEST_CASE("a range is laid out, and what is outside of its lines stays") {
  test::MarkedSource source("(defevent  e)\n[[(defevent  f)\n]](defevent  g)\n");
  auto document = Document::parse(source.text);
  CHECK(syntax::applyEdits(source.text, syntax::formatRange(document, source.range())) ==
        "(defevent  e)\n(defevent f)\n(defevent  g)\n");
}

namespace {

/// After a character was typed before the mark.
std::string typed(std::string_view marked) {
  test::MarkedSource source(marked);
  auto document = Document::parse(source.text);
  auto caret = source.point();
  return syntax::applyEdits(source.text,
                            syntax::formatTyped(document, caret, source.text[caret - 1]));
}

} // namespace

TEST_CASE("a new line is indented as the formatter would, whether the program is complete or not") {
  CHECK(typed("(defskill m \n^") == "(defskill m\n  ");
  CHECK(typed("(defskill m\n  :body\n^") == "(defskill m\n  :body\n    ");
  CHECK(typed("(defskill m\n  :body\n    ((f)\n^") == "(defskill m\n  :body\n    ((f)\n     ");
  CHECK(typed("((if (a B)\n^") == "((if (a B)\n    ");
  CHECK(typed("((if (a B)\n    (f)\n^   else") == "((if (a B)\n    (f)\n  else");
  CHECK(typed("((// ((f)) ; one\n^") == "((// ((f)) ; one\n     ");
  CHECK(typed("(defskill m\n  :success done (:effects (a B)\n^)") ==
        "(defskill m\n  :success done (:effects (a B)\n                 )");
  CHECK(typed("(defskill m\n  :success done\n^(:effects (a B))") ==
        "(defskill m\n  :success done\n    (:effects (a B))");
  CHECK(typed("(defskill m\n  :success done\n^:failure lost") ==
        "(defskill m\n  :success done\n  :failure lost");
  CHECK(typed("(defskill m\n  :success (done)\n^(") == "(defskill m\n  :success (done)\n  (");
  CHECK(typed("(defskill m\n  :precondition (a (b C)\n^") ==
        "(defskill m\n  :precondition (a (b C)\n                 ");
  CHECK(typed("(defsv a :init 1 :max 2)\n   ^") == "(defsv a :init 1 :max 2)\n   ");
  CHECK(typed("(defsv a :init 1 :max 2)\n^   ") == "(defsv a :init 1 :max 2)\n");
}

TEST_CASE("Enter indents the line that it ends, too") {
  CHECK(typed("(defskill m\n:body \n^") == "(defskill m\n  :body\n    ");
  CHECK(typed("(defskill m\n  :body\n  ((f)\n^  (g)") ==
        "(defskill m\n  :body\n    ((f)\n     (g)");
  CHECK(typed("(defskill m\n:body\n((f)\n^") == "(defskill m\n:body\n    ((f)\n     ");
  CHECK(typed("(defskill m\n \n^") == "(defskill m\n\n  ");
  CHECK(typed("(defskill m\n  ; what follows\n^") == "(defskill m\n  ; what follows\n  ");
  CHECK(typed("(defskill m\n; of what follows\n^") == "(defskill m\n; of what follows\n  ");
}

TEST_CASE("lines that were typed are indented below each other, and no others") {
  const std::string text = "(defevent  e)\n  (defskill m\n:body\n   ((f)  \n  \n (g)\n(h)\n";
  const auto document = Document::parse(text);
  const auto formatted = [&](std::vector<std::uint32_t> lines) {
    return syntax::applyEdits(text, syntax::formatLines(document, lines));
  };
  CHECK(formatted({1, 2, 3, 4, 5}) ==
        "(defevent  e)\n(defskill m\n  :body\n    ((f)\n\n     (g)\n(h)\n");
  CHECK(formatted({3, 5}) ==
        "(defevent  e)\n  (defskill m\n:body\n      ((f)\n  \n       (g)\n(h)\n");
  CHECK(formatted({}) == text);
}

TEST_CASE("typed lines keep their ends") {
  CHECK(typed("(defskill m\r\n:body \r\n^") == "(defskill m\r\n  :body\r\n    ");
  CHECK(typed("(defskill m\r\n \r\n^  \r\n(f)\r\n") == "(defskill m\r\n\r\n  \r\n(f)\r\n");
  CHECK(typed("(defevent   e\r\n:effects ( a  B ))^\r\n") ==
        "(defevent e\r\n  :effects (a B))\r\n");
  const std::string text = "(defskill m\r\n:body \r\n((f)\t\r\n \r\n(g)";
  const std::array lines{1U, 2U, 3U, 4U};
  CHECK(syntax::applyEdits(text, syntax::formatLines(Document::parse(text), lines)) ==
        "(defskill m\r\n  :body\r\n    ((f)\r\n\r\n     (g)");
}

TEST_CASE("lines are indented where the formatter puts them") {
  for (const auto& program : test::allPrograms()) {
    const auto text = formatted(program);
    const auto document = Document::parse(text);
    for (std::uint32_t line = 0; line < document.lines().lineCount(); ++line) {
      INFO(text.substr(0, document.lines().line(line, text).end));
      CHECK(syntax::formatLines(document, std::array{line}).empty());
    }
  }
}

TEST_CASE("a definition that is closed is laid out, and nothing around it") {
  CHECK(typed("(defevent  f)\n(defevent   e :effects ( a  B ))^\n(defevent  g)\n") ==
        "(defevent  f)\n(defevent e :effects (a B))\n(defevent  g)\n");
  CHECK(typed("(defevent   e :effects ( a  B )^)") == "(defevent   e :effects ( a  B ))");
  CHECK(typed("(defevent   e :effects ( a  B )^") == "(defevent   e :effects ( a  B )");
  CHECK(typed("(defevent   e ; (  )^\n)") == "(defevent   e ; (  )\n)");
  CHECK(typed("(defskill m :body ((printf \"(  )^\" 1)))") ==
        "(defskill m :body ((printf \"(  )\" 1)))");
}

TEST_CASE("a minus that touches a name stands apart from it afterwards") {
  const auto before = Document::parse("(defproperty p (always (-a B)))\n");
  const auto after = Document::parse(applyEdits(before.text(), format(before)));
  CHECK(after.text() == "(defproperty p (always (- a B)))\n");
  CHECK(sameTokens(before, after));
}

TEST_CASE("signs that touch words stand apart from them afterwards") {
  const auto same = [](const char* a, const char* b) {
    return sameTokens(Document::parse(a), Document::parse(b));
  };
  for (const std::string text : {"(0-)", "(0-b)", "(0-1)", "(1.5- 0-)", "(!-2)", "(:i-)", "($x-)",
                                 "(x.- a:b-)", "(^-1 0--1)", "(a =-1 <--b)"}) {
    INFO(text);
    const auto before = Document::parse(text);
    const auto after = Document::parse(applyEdits(text, format(before)));
    CHECK(sameTokens(before, after));
    CHECK(format(after).empty());
  }
  CHECK(same("(0-)", "(0 -)"));
  CHECK_FALSE(same("(a-)", "(a -)"));
  CHECK_FALSE(same("(a0-)", "(a0 -)"));
  CHECK(same("($0-)", "($0 -)"));
  CHECK_FALSE(same("(- 1)", "(-1)"));
  CHECK(same("(!-2)", "(!- 2)"));
  CHECK_FALSE(same("(!-2)", "(! -2)"));
  CHECK_FALSE(same("(> = a)", "(>= a)"));
  CHECK_FALSE(same("(0- 1)", "(0-1)"));
}

TEST_CASE("where a quote is missing at the end of a line, the lines stay as they are") {
  const auto text = "(())\n(\"\n((())))\n";
  const auto before = Document::parse(text);
  CHECK(unformattable(before).size() == 1);
  CHECK(sameTokens(before, Document::parse(applyEdits(text, format(before)))));
}
