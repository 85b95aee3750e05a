#include "analysis/flow/inspect.h"
#include "analysis/names/reuse.h"
#include "tests/support/memory_files.h"
#include "tests/support/random/random_edits.h"
#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

#include <array>

namespace proskill::test::reuse_test {

using analysis::Analysis;
using analysis::Program;
using syntax::Document;

namespace {

Program programOf(const Document& document) {
  return analysis::load(test::MemoryFiles(), "main.proskill", document);
}

/// A root file and one that it includes, as an editor holds them.
struct TwoFiles : test::MemoryFiles {
  std::array<Document, 2> documents;

  /// The second half of a program's definitions includes the first.
  explicit TwoFiles(const std::string& text)
      : documents{Document::parse("(include \"rest.proskill\")\n" + text.substr(middleOf(text))),
                  Document::parse(text.substr(0, middleOf(text)))} {}

  static std::size_t middleOf(const std::string& text) {
    const auto at = text.find("\n(def", text.size() / 2);
    return at == std::string::npos ? text.size() : at + 1;
  }
  [[nodiscard]] std::expected<Document, std::string>
  document(const std::filesystem::path& path) const override {
    if (path == "rest.proskill") return documents[1];
    return std::unexpected("no such file");
  }
  [[nodiscard]] Program program() const {
    return analysis::load(*this, "main.proskill", documents[0]);
  }
};

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

/// Everything that an analysis reports, for comparison.
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

/// Number of edits, and how often results were reused.
struct Counts {
  int edits = 0;
  int analyses = 0;
  int flows = 0;
};

/// The flow analysis, too, for edits of white space or a comment.
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

/// Inserts `text` at the only `|`.
struct Put {
  Document before;
  Document now;
};
Put putIn(std::string text, std::string_view put) {
  const auto at = static_cast<syntax::Offset>(text.find('|'));
  text.erase(at, 1);
  const Document before = Document::parse(text);
  return {before, before.edit({at, at}, put)};
}

/// What is reused for the edit.
Counts countsOf(const std::string& text, std::string_view put) {
  const auto [before, now] = putIn(text, put);
  Counts counts;
  compare(before, now, counts);
  return counts;
}

template <class Node>
void addLookedAt(const analysis::Scope& scope, const analysis::Table<Node>& table,
                 std::string& names) {
  for (const auto& it : table.all)
    if (scope.holds(it.file, it.form->range.begin)) names += std::string(it.name()) + ' ';
}

/// The definitions that are checked again, kind by kind, if the analysis equals a fresh one.
std::string lookedAt(const std::string& text, std::string_view put) {
  const auto [before, now] = putIn(text, put);
  Counts counts;
  compare(before, now, counts);
  const Program old = programOf(before);
  const Program program = programOf(now);
  const Analysis earlier = analysis::analyse(old);
  const auto reuse = analysis::Reuse::find({old, earlier}, program, analysis::SymbolTable(program));
  if (!reuse) return "all";
  std::string names;
  addLookedAt(reuse->scope(), program.stateVariables, names);
  addLookedAt(reuse->scope(), program.events, names);
  addLookedAt(reuse->scope(), program.skills, names);
  addLookedAt(reuse->scope(), program.resources, names);
  addLookedAt(reuse->scope(), program.properties, names);
  return names;
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

TEST_CASE("after an edit of one of two files the analysis equals a fresh one") {
  std::uint64_t seed = 300;
  int taken = 0;
  int edited = 0;
  for (const auto& text : test::allPrograms()) {
    test::RandomEdits edits(seed++);
    TwoFiles files(text);
    for (int i = 0; i < 30; ++i) {
      const Program before = files.program();
      const Analysis earlier = analysis::analyse(before);
      Document& document = files.documents[edits.pick(2)];
      const auto edit = edits.any(document.text());
      document = document.edit(edit.range, edit.text);
      const Program now = files.program();
      INFO("edit " << i << " at " << edit.range.begin << "-" << edit.range.end << ": " << edit.text
                   << "\nnow\n"
                   << document.text());
      CHECK(words(analysis::analyse(now, {before, earlier})) == words(analysis::analyse(now)));
      taken +=
          analysis::Reuse::find({before, earlier}, now, analysis::SymbolTable(now)).has_value();
      ++edited;
      if (edits.pick(6) == 0) files = TwoFiles(text);
    }
  }
  CHECK(taken > edited / 3);
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
  CHECK(lookedAt("(defsv height :min 0 :max 1| :init 1)\n" + number, "0") == "height m ");
  CHECK(countsOf("(defsv height :min 0 :max 10 :init |)\n" + number, "1").analyses == 1);
}

TEST_CASE("what others see of a definition matters to who has its name") {
  const std::string call = "(defskill m :body ((s) (^ (lamp On))))\n";
  const std::string skill = "(defskill s | :action (a))\n";
  const std::string others = "(defskill t :start (lamp Off) :action (a))\n(defevent dusk)\n";
  CHECK(lookedAt(kLamp + call + others + skill, ":input ($x nat)") == "m s ");
  CHECK(lookedAt(kLamp + call + others + skill, ":monitor t") == "m s ");
  CHECK(lookedAt(kLamp + call + others + skill, ":success done") == "m s ");
  CHECK(lookedAt("(defsv lamp :states (On |Off) :init Off)\n" + call + others, "Dim ") ==
        "lamp m t ");
}

TEST_CASE("a name that comes or goes matters to who has that word") {
  const std::string events = "(defevent dawn|)\n(defevent noon)\n";
  const std::string users = "(defskill m :body ((emit dawn) (emit dawns)))\n"
                            "(defskill n :body ((emit noon)))\n(defskill dawn :action (a))\n"
                            "(defsv dawns :states (A) :init A)\n";
  CHECK(lookedAt(events + users, "s") == "dawns dawns m dawn ");
  CHECK(lookedAt(users + "|(defevent noon)\n", "(defevent dawns)\n") == "dawns dawns m ");
  const std::string far = "(defproperty p :reachable (at there))\n(defskill n :action (a))\n";
  CHECK(lookedAt(far + "(defskill m :body ((label the|)))\n", "re") == "m p ");
}

TEST_CASE("the type of an input matters to who calls the skill") {
  const std::string skills = "(defskill s :input ($l lamp) :action (a $l))\n"
                             "(defskill m :body ((s :l 7)))\n(defskill n :action (a))\n";
  CHECK(lookedAt("(defsv lamp| :states (On Off) :init Off)\n" + skills, "s") == "lamps s m ");
}

TEST_CASE("the first of two definitions of a name is who has it, also after an edit") {
  const std::string twice = "(defevent dawn|)\n(defevent dawn)\n(defevent noon)\n"
                            "(defskill m :body ((emit dawn)))\n(defskill n :body ((emit noon)))\n";
  CHECK(lookedAt(twice, "s") == "dawns dawn m ");
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

} // namespace proskill::test::reuse_test
