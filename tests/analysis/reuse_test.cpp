#include "analysis/flow/inspect.h"
#include "analysis/reuse.h"
#include "tests/support/memory_files.h"
#include "tests/support/random_edits.h"
#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

using namespace proskill;
using analysis::Analysis;
using analysis::Program;
using syntax::Document;

namespace {

Program programOf(const Document& document) {
  return analysis::load(test::MemoryFiles(), "main.proskill", document);
}

std::string words(const analysis::Location& at) {
  return fmt::format(" {}:{}-{}", at.file, at.range.begin, at.range.end);
}

std::string words(const std::vector<syntax::Diagnostic>& diagnostics) {
  std::string all;
  for (const auto& it : diagnostics) {
    all += fmt::format("\n{} {} {}", syntax::info(it.code).id, static_cast<int>(it.severity),
                       it.message + words(it.location));
    for (const auto& related : it.related)
      all += "\n  " + related.message + words(related.location);
    for (const auto& fix : it.fixes)
      all += "\n  " + fix.title + words(fix.location) + " to " + fix.text;
  }
  return all;
}

/// Everything that an analysis says, so that two can be compared.
std::string words(const Analysis& analysis) {
  std::string all = words(analysis.diagnostics);
  for (const auto& symbol : analysis.index.symbols().all())
    all += fmt::format("\nsymbol {}", symbol.name) + words(symbol.at);
  for (const auto& it : analysis.index.occurrences())
    all += fmt::format("\n{} {}", it.symbol, static_cast<int>(it.role)) + words(it.at);
  for (analysis::SymbolId id = 0; id < analysis.index.symbols().all().size(); ++id)
    all += fmt::format("\n{} times", analysis.index.occurrencesOf(id).size());
  return all;
}

/// How often something was taken over, of how many edits.
struct Counts {
  int edits = 0;
  int analyses = 0;
  int flows = 0;
};

/// The flow's findings, too, where it was white space or a comment.
bool isFlowTakenOver(const Program& before, const Analysis& earlier, const Program& now,
                     const Analysis& fresh) {
  const auto edit = analysis::changeBetween(before, now);
  REQUIRE(edit);
  if (!edit->change.layout || !analysis::flow::hasFlow(before, earlier)) return false;
  REQUIRE(analysis::flow::hasFlow(now, fresh));
  const auto old = analysis::flow::checkFlow(before, earlier.index);
  const auto moved = analysis::movedByLayout(old, *edit);
  if (moved) CHECK(words(*moved) == words(analysis::flow::checkFlow(now, fresh.index)));
  return moved.has_value();
}

void compare(const Document& before, const Document& now, Counts& counts) {
  const Program old = programOf(before);
  const Program program = programOf(now);
  const Analysis earlier = analysis::analyse(old);
  const Analysis fresh = analysis::analyse(program);
  CHECK(words(analysis::analyse(program, {old, earlier})) == words(fresh));
  ++counts.edits;
  counts.analyses +=
      analysis::Reuse::find({old, earlier}, program, fresh.index.symbols()).has_value();
  counts.flows += isFlowTakenOver(old, earlier, program, fresh);
}

/// What is taken over for an edit of the only `|`, where `text` is put in.
Counts countsOf(std::string text, std::string_view put) {
  const auto at = static_cast<syntax::Offset>(text.find('|'));
  text.erase(at, 1);
  const Document before = Document::parse(text);
  Counts counts;
  compare(before, before.edit({at, at}, put), counts);
  return counts;
}

constexpr const char* kLamp = "(defsv lamp :states (On Off) :init Off)\n";

} // namespace

TEST_CASE("after any edit the analysis equals a fresh one") {
  std::uint64_t seed = 1;
  Counts counts;
  for (const auto& text : test::allPrograms()) {
    test::RandomEdits edits(seed++);
    Document document = Document::parse(text);
    for (int i = 0; i < 60; ++i) {
      const auto edit =
          edits.pick(2) == 0 ? edits.slip(document.text()) : edits.touch(document.text());
      const Document edited = document.edit(edit.range, edit.text);
      INFO("edit " << i << " at " << edit.range.begin << "-" << edit.range.end << ": " << edit.text
                   << "\nof\n"
                   << document.text());
      compare(document, edited, counts);
      document = edits.pick(6) == 0 ? Document::parse(text) : edited;
    }
  }
  CHECK(counts.analyses > counts.edits / 4);
  CHECK(counts.flows > 5);
}

TEST_CASE("after an edit of a program with misspelt names the analysis equals a fresh one") {
  std::uint64_t seed = 200;
  Counts counts;
  for (const auto& text : test::allPrograms()) {
    test::RandomEdits edits(seed++);
    Document document = Document::parse(text);
    for (int i = 0; i < 40; ++i) {
      const auto edit = i % 3 == 1 ? edits.touch(document.text()) : edits.misspell(document.text());
      const Document edited = document.edit(edit.range, edit.text);
      INFO("edit " << i << " at " << edit.range.begin << "-" << edit.range.end << ": " << edit.text
                   << "\nof\n"
                   << document.text());
      compare(document, edited, counts);
      document = i % 20 == 19 ? Document::parse(text) : edited;
    }
  }
  CHECK(counts.analyses > counts.edits / 3);
}

TEST_CASE("after several edits at once the analysis equals a fresh one") {
  std::uint64_t seed = 100;
  Counts counts;
  for (const auto& text : test::allPrograms()) {
    test::RandomEdits edits(seed++);
    const Document before = Document::parse(text);
    Document now = before;
    for (int i = 0; i < 10; ++i) {
      const auto edit = edits.touch(now.text());
      now = now.edit(edit.range, edit.text);
      compare(before, now, counts);
    }
  }
  CHECK(counts.analyses > counts.edits / 4);
}

TEST_CASE("an edit within a skill leaves the others as they are") {
  const auto counts = countsOf(std::string(kLamp) + "(defskill s :start (lamp O|) :action (a))\n"
                                                    "(defskill t :body ((s) (r)))\n",
                               "n");
  CHECK(counts.analyses == 1);
}

TEST_CASE("names that mean nothing do not have the other definitions looked at again") {
  const std::string text = std::string(kLamp) + "(defskill s :start (lamp O|) :action (a))\n"
                                                "(defskill t :body ((s) (r) (r) (emit dawn)))\n"
                                                "(defskill u :start (lam Onn) :body ((r)))\n";
  CHECK(countsOf(text, "n").analyses == 1);
  CHECK(countsOf(text, "x").analyses == 1);
  CHECK(countsOf(text, "n ; a comment\n").analyses == 1);
  CHECK(
      countsOf("(defskill s :body ((se) (se)))\n(defskill t :body ((s) (see|)))\n", "d").analyses ==
      1);
}

TEST_CASE("what nobody else sees of a definition does not matter elsewhere") {
  const std::string user = "(defskill m :start (lamp On) :resources (r) :body ((emit dusk)))\n";
  CHECK(countsOf("(defsv lamp :states (On Off) :init O|)\n" + user, "n").analyses == 1);
  CHECK(countsOf(kLamp + user + "(defevent dusk :effects (lamp O|))\n", "n").analyses == 1);
  CHECK(countsOf(kLamp + user + "(defresource r :capacity |)\n", "1").analyses == 1);
  const std::string number = "(defskill m :start (height 7) :action (a))\n";
  CHECK(countsOf("(defsv height :min 0 :max 1| :init 1)\n" + number, "0").analyses == 0);
  CHECK(countsOf("(defsv height :min 0 :max 10 :init |)\n" + number, "1").analyses == 1);
}

TEST_CASE("what others see of a definition matters everywhere") {
  const std::string call = "(defskill m :body ((s) (^ (lamp On))))\n";
  const std::string skill = "(defskill s | :action (a))\n";
  CHECK(countsOf(kLamp + call + skill, ":input ($x nat)").analyses == 0);
  CHECK(countsOf(kLamp + call + skill, ":monitor t").analyses == 0);
  CHECK(countsOf(kLamp + call + skill, ":success done").analyses == 0);
  CHECK(countsOf("(defsv lamp :states (On |Off) :init Off)\n" + call, "Dim ").analyses == 0);
}

TEST_CASE("a comment changes nothing but places") {
  const auto counts =
      countsOf(std::string(kLamp) + "(defevent dusk :effects (lamp On))\n"
                                    "(defskill s ; what|\n  :start (lamp On) :time_interval [1,2]\n"
                                    "  :action (a) :success done (:effects (lamp Off)))\n"
                                    "(defskill m :success well\n"
                                    "  :body ((^ (lamp On)) (s) (success well)))\n",
               " it does");
  CHECK(counts.analyses == 1);
  CHECK(counts.flows == 1);
}

TEST_CASE("a comment in a state variable does not matter to the edit that allows a move") {
  const std::string text = "(defsv lamp\n  :states (On Off Dim)|\n  :init Off\n"
                           "  :transitions ((Off Dim) (Dim On)))\n"
                           "(defskill m :success well :body ((set (lamp On)) (success well)))\n";
  CHECK(countsOf(text, " ; of the hall").flows == 1);
  CHECK(countsOf(text, "\n").flows == 1);
}
