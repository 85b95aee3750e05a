#include "analysis/names/index.h"
#include "tests/analysis/findings.h"
#include "tests/support/marked_source.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

using namespace proskill;
using analysis::Role;
using analysis::SymbolKind;

namespace {

struct Indexed {
  analysis::Program program;
  analysis::Analysis analysis;

  explicit Indexed(const std::string& text)
      : program(
            analysis::load(test::MemoryFiles(), "main.proskill", syntax::Document::parse(text))),
        analysis(analysis::analyse(program)) {}

  [[nodiscard]] const analysis::Index& index() const { return analysis.index; }
  [[nodiscard]] std::string text(const analysis::Occurrence& it) const {
    return program.files[0].document.text().substr(it.at.range.begin, it.at.range.length());
  }
};

/// The occurrences of the name at the `^` are those between `[[` and `]]`, in the order of the
/// text.
void expectOccurrences(std::string_view marked) {
  const test::MarkedSource source(marked);
  const Indexed indexed(source.text);
  INFO(source.text);
  REQUIRE(source.points.size() == 1);
  CHECK(test::findings(source.text) == "");
  const auto* here = indexed.index().at(0, source.point());
  REQUIRE(here);
  std::vector<syntax::Range> found;
  for (const auto& it : indexed.index().occurrencesOf(here->symbol)) found.push_back(it.at.range);
  CHECK(found == source.ranges);
}

} // namespace

TEST_CASE("every mention of a state variable is found from any of them") {
  expectOccurrences("(defsv [[mode]] :states (A B) :init A)"
                    "(defevent e :effects ([[mo^de]] B))"
                    "(defskill s :precondition (ok ([[mode]] A)) :action (s))"
                    "(defskill m :body ((^ (= [[mode]] B)) (^ (< 1 2) :effects ([[mode]] A))"
                    "  (printf \"%s\" [[mode]]) (s)))"
                    "(defproperty p (never (value [[mode]] B)))");
}

TEST_CASE("values belong to their variable") {
  expectOccurrences("(defsv a :states ([[O^n]] Off) :init [[On]] :transitions (([[On]] Off)))"
                    "(defsv b :states (On Off) :init On)"
                    "(defevent e :effects ((a [[On]]) (b On)))");
}

TEST_CASE("skills are found where they are called, interrupted and observed") {
  expectOccurrences("(defskill [[fly]] :action (fly) :interrupt (:effects (m A)))"
                    "(defsv m :states (A) :init A)"
                    "(defskill go :body ((// (([[fly]])) ((^ 1) ([[f^ly]].interrupt)))"
                    "  (if (= [[fly]].status success) (^ 1))))"
                    "(defproperty p (reachable (running [[fly]])))"
                    "(defproperty q (infinitelyoften (m A) :fair (go [[fly]])))");
}

TEST_CASE("inputs are found with and without their dollar") {
  expectOccurrences(
      "(defskill fly :input ($[[height]] float $yaw float) :action (fly $[[^height]] $yaw))"
      "(defskill go :body ((fly yaw 1 [[height]] 2)))");
}

TEST_CASE("tags are found in bodies and in tests") {
  expectOccurrences("(defskill fly :success done :action (fly))"
                    "(defskill go :success ([[d^one]]) :body ((fly) (if (= fly.res done) "
                    "(success [[done]]))))");
}

TEST_CASE("labels, events and resources are found") {
  expectOccurrences("(defskill go :body ((label [[again]]) (^ 1) (goto [[a^gain]])))"
                    "(defproperty p (reachable (at [[again]])))");
  expectOccurrences("(defsv m :states (A) :init A) (defevent [[e]] :effects (m A))"
                    "(defenvironment w :body ((emit [[^e]])))"
                    "(defproperty p (reachable (occurs [[e]])))");
  expectOccurrences("(defresource [[^arm]]) (defskill s :resources ([[arm]]) :action (s))");
}

TEST_CASE("a type is a mention of its state variable") {
  expectOccurrences("(defsv [[place]] :states (A B) :init A)"
                    "(defskill s :input ($to [[^place]]) :action (s $to))");
}

TEST_CASE("occurrences tell what is done with the symbol") {
  const Indexed indexed("(defsv m :states (A B) :init A)"
                        "(defskill s :action (s) :interrupt (:effects (m A)))"
                        "(defskill go :body ((s) (s.interrupt) (^ (m B)) (set (m A))))");
  auto roles = [&](SymbolKind kind, std::string_view name) {
    std::vector<Role> found;
    const auto symbol = indexed.index().symbols().find(kind, name);
    for (const auto& it : indexed.index().occurrencesOf(symbol)) found.push_back(it.role);
    return found;
  };
  CHECK(roles(SymbolKind::StateVariable, "m") ==
        std::vector{Role::Definition, Role::Write, Role::Read, Role::Write});
  CHECK(roles(SymbolKind::Skill, "s") ==
        std::vector{Role::Definition, Role::Call, Role::Interrupt});
}

TEST_CASE("an occurrence covers exactly the name") {
  const Indexed indexed(test::mission("(takeoff height 1 duration 2) (label a) (goto a)"
                                      "(^ (and (battery Low) (> level 1)))"));
  for (const auto& it : indexed.index().occurrences())
    CHECK(indexed.text(it) == indexed.index().symbols()[it.symbol].name);
  CHECK(indexed.index().occurrences().size() > 40);
}

TEST_CASE("no name stands between names") {
  const Indexed indexed("(defresource arm)  (defresource leg)");
  CHECK(indexed.index().at(0, 0) == nullptr);
  CHECK(indexed.index().at(0, 13) != nullptr);
  CHECK(indexed.index().at(0, 16) != nullptr);
  CHECK(indexed.index().at(0, 18) == nullptr);
  CHECK(indexed.index().at(7, 13) == nullptr);
}

TEST_CASE("the uses of a constant") {
  const std::string text = "(defconst two 2)(defsv n :init two :min 0 :max two)"
                           "(defskill m :body ((^ two) (^ [two,two]) (^ (= n two) :timeout two)))";
  const Indexed indexed(text);
  const auto two = indexed.index().symbols().find(analysis::SymbolKind::Constant, "two");
  CHECK(indexed.index().occurrencesOf(two).size() == 8);
}
