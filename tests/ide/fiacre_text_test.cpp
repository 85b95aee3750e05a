#include "ide/fiacre/fiacre_rename.h"
#include "ide/fiacre/fiacre_text.h"

#include "tests/support/marked_source.h"
#include "tests/support/texts.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace proskill;
using ide::FiacreText;
using syntax::Range;
using test::MarkedSource;

namespace {

/// The marked ranges are the uses of the name at `^`, its declaration first.
void namesAre(std::string_view marked) {
  const MarkedSource source(marked);
  INFO(source.text);
  const FiacreText text(source.text);
  for (const auto at : source.ranges) {
    std::vector<Range> found;
    for (const auto& use : text.uses(at.begin, true)) found.push_back(use.range);
    CHECK(found == source.ranges);
    CHECK(text.uses(at.end, true).size() == found.size());
    REQUIRE(text.definition(at.begin).has_value());
    CHECK(*text.definition(at.begin) == source.ranges.front());
  }
}

std::string hovered(std::string_view marked) {
  const MarkedSource source(marked);
  const auto hover = FiacreText(source.text).hover(source.point());
  return hover ? hover->text.plain() : "nothing";
}

/// The labels of a kind that are offered at `^`, or of all kinds.
std::string offered(std::string_view marked, std::optional<ide::CompletionKind> kind = {}) {
  const MarkedSource source(marked);
  std::string labels;
  for (const auto& item : FiacreText(source.text).complete(source.point()).items)
    if (!kind || item.kind == *kind) labels += (labels.empty() ? "" : " ") + item.label;
  return labels;
}

std::string outlined(const std::vector<ide::FiacreEntry>& entries) {
  std::string result;
  for (const auto& entry : entries) {
    result += (result.empty() ? "" : " ") + entry.name;
    if (!entry.children.empty()) result += "(" + outlined(entry.children) + ")";
  }
  return result;
}

std::vector<std::string> examples() {
  std::vector<std::string> texts;
  for (const auto& entry :
       std::filesystem::directory_iterator(PROSKILL_SOURCE_DIR "/examples/fiacre"))
    if (entry.path().extension() == ".fcr") {
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      texts.push_back(text.str());
    }
  REQUIRE(texts.size() > 10);
  return texts;
}

bool isWithin(Range range, const std::string& text) {
  return range.begin < range.end && range.end <= text.size();
}

void isInOrder(const std::vector<ide::FiacreEntry>& entries, Range outer) {
  for (const auto& entry : entries) {
    CHECK((outer.begin <= entry.range.begin && entry.range.end <= outer.end));
    CHECK((entry.range.begin <= entry.selection.begin && entry.selection.end <= entry.range.end));
    isInOrder(entry.children, entry.range);
  }
}

/// Everything that can be requested at a place.
void isAnswered(const FiacreText& fiacre, const std::string& text, syntax::Offset at) {
  if (const auto definition = fiacre.definition(at)) CHECK(isWithin(*definition, text));
  for (const auto& use : fiacre.uses(at, true)) CHECK(isWithin(use.range, text));
  if (const auto hover = fiacre.hover(at)) {
    CHECK(isWithin(hover->range, text));
    CHECK_FALSE(hover->text.empty());
  }
  const auto found = fiacre.complete(at);
  CHECK((found.insert.end == at && found.insert.begin <= at && found.replace.end >= at));
}

void isAnswered(const std::string& text) {
  const FiacreText fiacre(text);
  const Range whole{0, static_cast<syntax::Offset>(text.size())};
  isInOrder(fiacre.outline(), whole);
  syntax::Offset before = 0;
  for (const auto& token : fiacre.tokens()) {
    CHECK((isWithin(token.range, text) && token.range.begin >= before));
    CHECK(text.substr(token.range.begin, token.range.length()).find('\n') == std::string::npos);
    before = token.range.end;
  }
  for (const auto& fold : fiacre.folds()) CHECK(fold.firstLine < fold.lastLine);
}

} // namespace

TEST_CASE("a name of Fiacre is that of its process") {
  namesAre(
      "process P (&[[x]]: nat) is\nstates s\nvar y: nat := 0\n"
      "from s [[x]] := y + [[x]]; to s\nprocess Q (&x: nat) is\nstates s\nfrom s x := 1; to s\n");
  namesAre("process P is\nstates a, [[b]]\nfrom a to [[b]]\nfrom [[b]] to a\n"
           "process Q is states b from b to b component m is par P || Q end m\n"
           "property p is absent m/1/state [[b]]\nassert p");
  namesAre("process P [q: sync, [[p]]: sync] is states a from a [[p]]; to a\n"
           "component m is port p: sync par * in P [p, p] end m");
}

TEST_CASE("a name of Fiacre is that of the whole text") {
  namesAre("const [[N]]: nat is 3\ntype t is 0..[[N]]\nprocess P is states a from a wait "
           "[1,[[N]]]; to a");
  namesAre("type [[t]] is union A | B of 0..3 end\nprocess P (&x: [[t]]) is states a from a x := "
           "A; to a");
  namesAre("type t is union [[A]] | B end\nfunction f (x: t): bool is begin return x = [[A]] end");
  namesAre("type r is record [[f]]: nat end\nprocess P (&x: r) is states a from a x.[[f]] := 1; "
           "x := {[[f]] = 2}; to a");
  namesAre("process [[P]] is states a from a loop component m is par [[P]] || [[P]] end");
  namesAre("component [[C]] is par end\ncomponent m is par [[C]] end m");
  namesAre("channel [[c]] is nat process P [p: [[c]]] is states a from a loop");
  namesAre("property [[p]] is deadlockfree\nassert [[p]]");
}

TEST_CASE("values on a path are those of what it leads to") {
  namesAre("process P is states a var [[x]]: nat from a [[x]] := 1; to a\n"
           "process Q is states a var x: nat from a loop\n"
           "component m is par P || Q end m property p is always m/1/value [[x]] > 0");
}

TEST_CASE("a declaration of Fiacre is shown with its comment") {
  CHECK(hovered("process P (a, &b: nat) is states s\nvar c, d: 0..3 := 0, // how many\n"
                "    e: bool\nfrom s ^d := 1; to s") == "var d: 0..3 := 0\n\nhow many");
  CHECK(hovered("process P [p: nat # bool, q: sync] is states s from s ^p ! 1, true; to s") ==
        "port p: nat # bool");
  CHECK(hovered("// What it is.\n// And does.\nprocess P [p: sync]\n  (&x: nat) is states s from s "
                "loop\ncomponent m is par ^P end") ==
        "process P [p: sync] (&x: nat)\n\nWhat it is.\nAnd does.");
  CHECK(hovered("const N: nat is 3 // many\ntype t is 0..^N") == "const N: nat is 3\n\nmany");
  CHECK(hovered("process P is ^states s") == "nothing");
}

TEST_CASE("Fiacre has an outline") {
  const std::string text =
      "const N: nat is 1\ntype t is union A | B end\nprocess P [p: sync] (&x: t) is\n"
      "states a, b\nvar y: nat\nfrom a #tag; to b\ncomponent m is\nvar x: t\n"
      "par P (&x) end\nm\nproperty q is deadlockfree";
  CHECK(outlined(FiacreText(text).outline()) == "N t(A B) P(p x a b y) m(x) q");
}

TEST_CASE("what can be written in Fiacre is offered") {
  using Kind = ide::CompletionKind;
  const std::string process = "process P is\nstates idle, busy\nvar count: nat\nfrom idle to ";
  CHECK(offered(process + "^") == "busy idle");
  CHECK(offered(process + "b^") == "busy idle");
  CHECK(offered(process + "busy from busy c^ := 1; to idle", Kind::Variable) == "count");
  CHECK(offered(process + "busy from busy // c^") == "");
  CHECK(offered("process ^") == "");
  CHECK(offered("property p is deadlockfree assert ^") == "p");
  const auto anything = offered(process + "busy from busy ^");
  CHECK(anything.starts_with("busy count idle P"));
  CHECK(anything.find(" select") != std::string::npos);
}

TEST_CASE("Fiacre is folded by declarations, states and blocks") {
  const std::string text =
      "// one\n// two\nprocess P is\nstates a\nfrom a\n  select\n    to a\n  [] to a\n"
      "  end\nfrom b\n  loop\n";
  const auto folds = FiacreText(text).folds();
  std::vector<std::pair<unsigned, unsigned>> lines;
  for (const auto& fold : folds) lines.emplace_back(fold.firstLine, fold.lastLine);
  using Lines = std::vector<std::pair<unsigned, unsigned>>;
  CHECK(lines == Lines{{0, 1}, {2, 10}, {4, 8}, {5, 8}, {9, 10}});
  CHECK(folds[0].kind == ide::FoldKind::Comment);
}

TEST_CASE("words of Fiacre are coloured by what they mean") {
  const std::string text = "process P (&x: nat) is states s /* a\nb */ from s x := 1; to s";
  std::string found;
  for (const auto& token : FiacreText(text).tokens())
    if (token.type != ide::TokenType::Operator && token.type != ide::TokenType::Keyword)
      found += text.substr(token.range.begin, token.range.length()) + ":" +
               std::to_string(static_cast<int>(token.type)) +
               (token.modifiers & ide::kDefinition ? "! " : " ");
  CHECK(found == "P:6! x:10! s:16! /* a:2 b */:2 s:16 x:10 1:4 s:16 ");
}

TEST_CASE("every place of every example of Fiacre is answered") {
  for (const auto& text : examples()) {
    isAnswered(text);
    const FiacreText fiacre(text);
    std::size_t named = 0;
    for (syntax::Offset at = 0; at <= text.size(); ++at) {
      isAnswered(fiacre, text, at);
      named += fiacre.definition(at) ? 1 : 0;
    }
    CHECK(named > text.size() / 10);
  }
}

TEST_CASE("every example of Fiacre is answered while it is typed") {
  for (const auto& text : examples())
    for (std::size_t length = 0; length < text.size(); length += 23) {
      const auto typed = text.substr(0, length);
      isAnswered(typed);
      isAnswered(FiacreText(typed), typed, static_cast<syntax::Offset>(length));
    }
}

TEST_CASE("every name of the examples of Fiacre is declared") {
  for (const auto& text : examples()) {
    const FiacreText fiacre(text);
    for (const auto& mention : proskill::fiacre::parse(text).mentions) {
      INFO(text.substr(mention.begin, 40));
      CHECK(fiacre.definition(mention.begin).has_value());
    }
  }
}

namespace {

/// The text after renaming the name at the first `^`, or an error.
std::string renamed(std::string text, std::string_view to) {
  const auto mark = text.find('^');
  text.erase(mark, 1);
  const auto places = ide::renameInFiacre(text, static_cast<syntax::Offset>(mark), to);
  if (!places) return "refused: " + places.error();
  for (auto i = places->size(); i-- > 0;)
    text.replace((*places)[i].begin, (*places)[i].end - (*places)[i].begin, to);
  return text;
}

} // namespace

TEST_CASE("renaming follows a name through its process, and paths to it") {
  CHECK(renamed("process P is states a, b from a to ^b process Q is states b from b to b "
                "component m is par P || Q end property p is absent m/1/state b m",
                "c") == "process P is states a, c from a to c process Q is states b from b to b "
                        "component m is par P || Q end property p is absent m/1/state c m");
  CHECK(
      renamed("type t is union ^up | down end process P (v: t) is states a from a on v = up; to a",
              "lit") ==
      "type t is union lit | down end process P (v: t) is states a from a on v = lit; to a");
}

TEST_CASE("renaming is refused where a name would mean something else, or nothing") {
  const std::string two = "process P is states ^a, b var x: nat from a x := 1; to b from b to a P";
  CHECK_THAT(renamed(two, "b"), Catch::Contains("refused"));
  CHECK(renamed(two, "from") == "refused: `from` is a keyword of Fiacre");
  CHECK_THAT(renamed(two, "1a"), Catch::Contains("is not a name"));
  CHECK_THAT(renamed("process P is states a var x: nat from a to a ^ P", "c"),
             Catch::Contains("not a name that is declared"));
  // A field that two records have: only the type says which is meant.
  CHECK_THAT(renamed("type r is record ^f: nat end type s is record f: nat end "
                     "process P is states a var x: r, y: s from a x.f := 1; y.f := 1; to a P",
                     "g"),
             Catch::Contains("the model would have an error"));
}

TEST_CASE("a refused renaming tells what it would do, not what is wrong anyway") {
  const std::string wrongAnyway =
      "process W is states a var ok: bool from a ok := 7; to a component c is par P || W end c";
  const auto said = renamed("type r is record ^f: nat end type s is record f: nat end process P is "
                            "states a var x: r, y: s from a x.f := 1; y.f := 1; to a " +
                                wrongAnyway,
                            "g");
  CHECK_THAT(said, Catch::Contains("the model would have an error"));
  CHECK_THAT(said, Catch::Contains("`y` has no field `g`"));
}
