#include "ide/features/hierarchy.h"
#include "tests/ide/marked_program.h"

#include <catch2/catch.hpp>

using namespace proskill;
using test::MarkedProgram;

namespace {

std::string written(const MarkedProgram& program, const std::vector<ide::Link>& links) {
  std::string result;
  for (const auto& link : links)
    result += std::string(program.view().index().symbols()[link.symbol].name) + ":" +
              std::to_string(link.places.size()) + " ";
  return result;
}

const std::string kProgram = "(defsv lamp :states (On Off) :init On)\n"
                             "(defsv door :states (Open Shut) :init Shut)\n"
                             "(defevent e :effects (lamp On))\n"
                             "(defskill go :precondition (p (door Open)) :action (x))\n"
                             "(defskill stop :action (x))\n"
                             "(defskill m :body ((go) (// ((stop) (go)) ((set (lamp On)) "
                             "(^ (lamp On)) (set (door Open)))) (go.interrupt)))\n";

analysis::SymbolId symbolIn(const MarkedProgram& program, std::string_view name) {
  const auto& symbols = program.view().index().symbols();
  const auto skill = symbols.find(analysis::SymbolKind::Skill, name);
  return skill != analysis::kNoSymbol ? skill
                                      : symbols.find(analysis::SymbolKind::StateVariable, name);
}

} // namespace

TEST_CASE("who calls a skill, whom it calls, and where") {
  const MarkedProgram program(kProgram);
  auto incoming = [&](std::string_view name) {
    return written(program, ide::incomingCalls(program.view(), symbolIn(program, name)));
  };
  auto outgoing = [&](std::string_view name) {
    return written(program, ide::outgoingCalls(program.view(), symbolIn(program, name)));
  };
  CHECK(incoming("go") == "m:2 ");
  CHECK(incoming("m").empty());
  CHECK(outgoing("m") == "go:2 stop:1 ");
  CHECK(outgoing("go").empty());
}

TEST_CASE("the users of a state variable, and the variables of a user") {
  const MarkedProgram program(kProgram);
  CHECK(written(program, ide::usersOfVariable(program.view(), symbolIn(program, "lamp"))) ==
        "e:1 m:2 ");
  CHECK(written(program, ide::usersOfVariable(program.view(), symbolIn(program, "door"))) ==
        "go:1 m:1 ");
  CHECK(written(program, ide::variablesOf(program.view(), symbolIn(program, "m"))) ==
        "lamp:2 door:1 ");
}

TEST_CASE("hierarchies begin at a name of the right kind") {
  const MarkedProgram call(kProgram + "(defskill n :body ((g^o)))");
  CHECK(ide::skillAt(call.view(), call.at()) == symbolIn(call, "go"));
  const MarkedProgram variable(kProgram + "(defevent f :effects (la^mp On))");
  CHECK(ide::userOrVariableAt(variable.view(), variable.at()) == symbolIn(variable, "lamp"));
  CHECK_FALSE(ide::skillAt(variable.view(), variable.at()));
  const MarkedProgram value(kProgram + "(defevent f :effects (lamp O^n))");
  CHECK_FALSE(ide::userOrVariableAt(value.view(), value.at()));
}
