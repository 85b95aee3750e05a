#include "ide/features/lenses.h"
#include "tests/ide/marked_program.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <set>

namespace proskill::test::lenses_test {

using test::MarkedProgram;

namespace {

const std::string kProgram = "(defsv lamp :states (On Off) :init Off)\n"
                             "(defevent e :effects (lamp On))\n"
                             "(defskill go :action (x))\n"
                             "(defproperty p (reachable (lamp On)))\n";

std::vector<std::string> titles(const MarkedProgram& program, const ide::Verdicts& verdicts,
                                std::string_view name) {
  std::vector<std::string> result;
  for (const auto& lens : ide::lenses(program.view(), verdicts))
    if (program.view().index().symbols()[lens.symbol].name == name) result.push_back(lens.title);
  return result;
}

using Titles = std::vector<std::string>;

ide::PropertyVerdict verdict(std::string name, ide::Verdict what,
                             std::optional<std::size_t> steps) {
  ide::PropertyVerdict result;
  result.subject = "go";
  result.name = std::move(name);
  result.verdict = what;
  result.steps = steps;
  return result;
}

ide::Verdicts verdictsFor(const MarkedProgram& program) {
  auto verdicts = std::make_shared<ide::ProgramVerdicts>();
  verdicts->program = program.view().owner;
  verdicts->properties = {verdict("go.a", ide::Verdict::Holds, {}),
                          verdict("go.b", ide::Verdict::Violated, {}),
                          verdict("go.c", ide::Verdict::Unreachable, 3),
                          verdict("go.d", ide::Verdict::Inconclusive, {})};
  return {{program.view().program().files.front().path, verdicts}};
}

} // namespace

TEST_CASE("each definition has the lenses that fit it") {
  const MarkedProgram program(kProgram);
  CHECK(titles(program, {}, "lamp") == Titles{"", "show automaton"});
  CHECK(titles(program, {}, "e") == Titles{""});
  CHECK(titles(program, {}, "go") == Titles{"", "show automaton", "verify"});
  CHECK(titles(program, {}, "p") == Titles{"verify"});
  CHECK(ide::lenses(MarkedProgram("(defsv) (defskill").view(), {}).empty());
}

TEST_CASE("verdicts are counted, and lead to a trace where there is one") {
  const MarkedProgram program(kProgram);
  const auto verdicts = verdictsFor(program);
  CHECK(titles(program, verdicts, "go").front() == "✗ 2 bad, 1 inconclusive, 1 good");
  for (const auto& lens : ide::lenses(program.view(), verdicts))
    if (lens.kind == ide::LensKind::Verdicts) CHECK(lens.property == "go.c");
}

TEST_CASE("warnings are counted apart from failures") {
  const MarkedProgram program(kProgram);
  auto properties = std::vector{verdict("go.a", ide::Verdict::Holds, {}),
                                verdict("go.b", ide::Verdict::Violated, 7)};
  properties.back().weight = codegen::Weight::Warning;
  auto verdicts = std::make_shared<ide::ProgramVerdicts>();
  verdicts->program = program.view().owner;
  verdicts->properties = properties;
  const ide::Verdicts all{{program.view().program().files.front().path, verdicts}};
  CHECK(titles(program, all, "go").front() == "✓ 1 warning, 1 good");
  verdicts->properties.push_back(verdict("go.c", ide::Verdict::Violated, 3));
  CHECK(titles(program, all, "go").front() == "✗ 1 bad, 1 warning, 1 good");
  for (const auto& lens : ide::lenses(program.view(), all))
    if (lens.kind == ide::LensKind::Verdicts) CHECK(lens.property == "go.c");
}

TEST_CASE("verdicts on an older text are called stale") {
  const MarkedProgram before(kProgram);
  const MarkedProgram now(kProgram + "(defresource arm)\n");
  CHECK(titles(now, verdictsFor(before), "go").front().ends_with("(outdated)"));
  // The same text, parsed again, counts as unchanged.
  CHECK_FALSE(
      titles(MarkedProgram(kProgram), verdictsFor(before), "go").front().ends_with("(outdated)"));
}

TEST_CASE("large files have lenses for what is verified first") {
  auto repeated = [](std::size_t count, std::string_view form) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
      text += fmt::format(fmt::runtime(form), fmt::arg("i", i)) + "\n";
    return text;
  };
  auto names = [](const std::string& text, const ide::Verdicts& verdicts) {
    const MarkedProgram program(text);
    std::set<std::string_view> kinds;
    for (const auto& lens : ide::lenses(program.view(), verdicts))
      kinds.insert(analysis::words(program.view().index().symbols()[lens.symbol].kind));
    return kinds.size() == 1 ? std::string(*kinds.begin()) : fmt::format("{} kinds", kinds.size());
  };
  const auto missions = repeated(ide::kMostWithLenses + 1, "(defskill m{i} :body ((^ 1)))");
  const auto skills = repeated(ide::kMostWithLenses - 1, "(defskill s{i} :action (x))");
  const auto variables = repeated(2, "(defsv v{i} :states (A B) :init A)");
  const std::string property = "(defproperty p (reachable (v0 B)))\n";
  CHECK(names(variables + property, {}) == "2 kinds");
  CHECK(names(variables + skills, {}) == "skill");
  CHECK(names(variables + missions, {}) == "skill");
  CHECK(names(variables + property + skills, {}) == "2 kinds");
  CHECK(names(variables + property + skills + "(defskill last :action (x))\n", {}) == "property");
  CHECK(names(repeated(ide::kMostWithLenses, "(defsv v{i} :states (A B) :init A)"), {}) ==
        "state variable");
}

TEST_CASE("references are counted in words") {
  CHECK(ide::referencesTitle(0) == "0 references");
  CHECK(ide::referencesTitle(1) == "1 reference");
}

} // namespace proskill::test::lenses_test
