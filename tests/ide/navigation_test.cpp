#include "ide/features/navigation.h"
#include "tests/ide/marked_program.h"

#include <catch2/catch.hpp>

using namespace proskill;
using test::MarkedProgram;

namespace {

using Places = std::vector<analysis::Location>;

Places one(std::optional<analysis::Location> place) { return place ? Places{*place} : Places{}; }

Places definitionOf(const MarkedProgram& program) {
  return one(ide::definition(program.view(), program.at()));
}

} // namespace

TEST_CASE("the definition of a name, from any place of it") {
  for (const auto* text : {
           "(defsv [[lamp]] :states (On Off) :init Off) (defevent e :effects (la^mp On))",
           "(defsv [[lamp]] :states (On Off) :init Off) (defevent e :effects (lamp^ On))",
           "(defsv [[lamp]] :states (On Off) :init Off) (defevent e :effects (^lamp On))",
           "(defsv [[^lamp]] :states (On Off) :init Off)",
           "(defsv lamp :states ([[On]] Off) :init Off) (defevent e :effects (lamp O^n))",
           "(defskill f :action (x)) (defskill m :body ((label [[l]]) (f) (goto l^)))",
           "(defskill f :input ($[[h]] int) :action (x $h^))",
       }) {
    INFO(text);
    const MarkedProgram program(text);
    CHECK(definitionOf(program) == program.marked());
  }
}

TEST_CASE("where no name stands, there is nothing to go to") {
  for (const auto* text :
       {"(defsv lamp ^ :states (On Off) :init Off)", "(defsv lamp :sta^tes (On Off) :init Off)",
        "; la^mp", "(defevent e :effects (nobody^ On))", "^"}) {
    INFO(text);
    const MarkedProgram program(text);
    CHECK(definitionOf(program).empty());
    CHECK(ide::references(program.view(), program.at(), true).empty());
    CHECK(ide::highlights(program.view(), program.at()).empty());
    CHECK(ide::implementations(program.view(), program.at()).empty());
  }
}

TEST_CASE("a definition in another file") {
  const MarkedProgram program({{"main.proskill", "(include \"lamp.proskill\")\n"
                                                 "(defevent e :effects (lamp^ On))"},
                               {"lamp.proskill", "(defsv [[lamp]] :states (On Off) :init Off)"}});
  CHECK(definitionOf(program) == program.marked());
}

TEST_CASE("from an included file, its root is known") {
  const MarkedProgram program({{"main.proskill", "(include \"e.proskill\")\n"
                                                 "(defsv [[lamp]] :states (On Off) :init Off)"},
                               {"e.proskill", "(defevent e :effects (lamp^ On))"}});
  CHECK(definitionOf(program) == program.marked());
}

TEST_CASE("the type of a value and of a parameter is its state variable") {
  for (const auto* text :
       {"(defsv [[lamp]] :states (On Off) :init O^ff)",
        "(defsv [[lamp]] :states (On Off) :init Off) (defskill f :input ($l lamp) :action (x $^l))",
        "(defsv lamp :states (On Off) :init Off) (defskill f :input ($l int) :action (x $^l))"}) {
    INFO(text);
    const MarkedProgram program(text);
    CHECK(one(ide::typeDefinition(program.view(), program.at())) == program.marked());
  }
}

TEST_CASE("what sets a state variable, or sets it to a value") {
  const std::string rest =
      " (defevent a :effects ([[lamp]] On)) (defevent b :effects ([[lamp]] Off))"
      " (defskill f :precondition (t (lamp Off)) :action (x))";
  const MarkedProgram program("(defsv ^lamp :states (On Off) :init Off)" + rest);
  CHECK(ide::implementations(program.view(), program.at()) == program.marked());
  const MarkedProgram value("(defsv lamp :states (^On Off) :init On :transitions ((On Off)))"
                            "(defevent a :effects (lamp [[On]])) (defevent b :effects (lamp Off))"
                            "(defskill f :precondition (t (lamp On)) :action (x))");
  CHECK(ide::implementations(value.view(), value.at()) == value.marked());
}

TEST_CASE("references, with the definition and without") {
  const std::string uses = "(defevent e :effects ([[lamp]] On)) (defskill f :precondition "
                           "(t (~ ([[lamp]] Off))) :action (x))";
  const MarkedProgram without("(defsv lamp^ :states (On Off) :init Off)" + uses);
  CHECK(ide::references(without.view(), without.at(), false) == without.marked());
  const MarkedProgram with("(defsv [[lamp^]] :states (On Off) :init Off)" + uses);
  CHECK(ide::references(with.view(), with.at(), true) == with.marked());
}

TEST_CASE("highlights say who reads and who writes, in this file alone") {
  const MarkedProgram program(
      {{"main.proskill", "(include \"lamp.proskill\") (defevent e :effects (^lamp On)) "
                         "(defskill f :precondition (t (lamp Off)) :action (x))"},
       {"lamp.proskill", "(defsv lamp :states (On Off) :init Off)"}});
  std::vector<analysis::Role> roles;
  for (const auto& place : ide::highlights(program.view(), program.at())) {
    CHECK(place.at.file == program.view().file);
    roles.push_back(place.role);
  }
  CHECK(roles == std::vector{analysis::Role::Write, analysis::Role::Read});
}
