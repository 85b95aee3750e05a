#include "fiacre/syntax/parse.h"

#include "codegen/model.h"
#include "fiacre/check/check.h"
#include "fiacre/print/print.h"
#include "tests/support/oracle/canonical.h"
#include "tests/support/random/random_model.h"
#include "tests/support/random/random_program.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

namespace proskill::test::parse_test {

using codegen::Edition;

namespace {

std::string problemsOf(const fiacre::Parsed& parsed, std::string_view text) {
  std::string all;
  for (const auto& problem : parsed.problems)
    all += "`" + std::string(text.substr(problem.begin, problem.end - problem.begin)) +
           "`: " + problem.message + "\n";
  return all;
}

std::string problemsOf(std::string_view text) { return problemsOf(fiacre::parse(text), text); }

/// Parsing a printed tree gives the same tree, but for what Fiacre cannot express.
void comesBack(fiacre::Program program) {
  std::erase_if(program.properties, [](const fiacre::Property& property) {
    return !fiacre::isOfFiacre(property.pattern.kind);
  });
  const auto text = fiacre::print(program);
  const auto parsed = fiacre::parse(text);
  INFO(text);
  REQUIRE(problemsOf(parsed, text) == "");
  const auto wanted = test::canonical(program);
  const auto got = test::canonical(parsed.program);
  CHECK(fiacre::print(got) == fiacre::print(wanted));
  CHECK(got == wanted);
}

std::string repeated(std::string_view part, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += part;
  return all;
}

fiacre::Process processOf(std::string_view body) {
  const auto text =
      "process P [p: in out nat, q: sync] (&x: nat, y: 0..3) is\n" + std::string(body);
  auto parsed = fiacre::parse(text);
  INFO(text);
  REQUIRE(problemsOf(parsed, text) == "");
  REQUIRE(parsed.program.processes.size() == 1);
  return test::canonical(parsed.program).processes[0];
}

} // namespace

TEST_CASE("what is printed of random models is read as it was") {
  for (std::uint64_t seed = 0; seed < 500; ++seed) comesBack(test::randomModel(seed));
}

TEST_CASE("what is printed of random models with observers is read as it was") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) comesBack(test::randomModelWithObserver(seed));
}

TEST_CASE("what is printed of the models of random programs is read as it was") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto program = test::programOfText(test::textOf(test::randomProgram(seed)));
    for (auto edition : {Edition::Compact, Edition::Expanded, Edition::Runtime}) {
      codegen::Options options;
      options.edition = edition;
      const auto model = codegen::generate(program, options);
      INFO(seed);
      if (model) comesBack(model->fiacre);
    }
  }
}

TEST_CASE("operators bind as in Fiacre") {
  const auto same = [](std::string_view text, std::string_view grouped) {
    INFO(text);
    const auto read = fiacre::parseExpr(text);
    REQUIRE(read.has_value());
    CHECK(read == fiacre::parseExpr(grouped));
  };
  same("a or b and c", "a or (b and c)");
  same("not a = b", "(not a) = b");
  same("a = b < c", "a = (b < c)");
  same("a - b - c", "(a - b) - c");
  same("a + b * c % d", "a + ((b * c) % d)");
  same("-1 + -x", "(-1) + (-x)");
  same("not empty q and full r", "(not (empty q)) and (full r)");
  same("a[i].f[j + 1]", "((a[i]).f)[j + 1]");
  same("(a ? b : c)", "a ? b : c");
  CHECK_FALSE(fiacre::parseExpr("a +"));
  CHECK_FALSE(fiacre::parseExpr("a b"));
  CHECK_FALSE(fiacre::parseExpr("99999999999999999999"));
}

TEST_CASE("statements are read") {
  const auto process = processOf(R"(
states idle, busy
var a, b: nat := 1, f: queue 2 of bool := {||}
init a := 2; to busy
from idle
  select
    p ? x where x < 3; to busy
  [] p ! x + 1; a, b := b, a; to busy
  unless q; #done; loop
  end
from busy
  if x = 0 then null elsif x = 1 then wait ]2,...[ else on a > b end;
  case y of 0 -> to idle | any -> while a < 3 do a := a + 1 end; to busy end
)");
  CHECK(process.variables.size() == 3);
  CHECK(process.variables[1].init == fiacre::parseExpr("1"));
  REQUIRE(process.transitions.size() == 2);
  const auto& select = process.transitions[0].statement;
  CHECK(select.children.size() == 3);
  CHECK(select.priorityGroups == std::vector<std::size_t>{2});
  CHECK(select.children[0].children[0].kind == fiacre::StatementKind::Receive);
  CHECK(select.children[1].children[1].targets.size() == 2);
  CHECK(select.children[2].children[0].kind == fiacre::StatementKind::Send);
  const auto& busy = process.transitions[1].statement;
  CHECK(busy.children[0].children[1].kind == fiacre::StatementKind::If);
  CHECK(busy.children[1].values[2].name == "any");
}

TEST_CASE("constants are put into types and times, channels into ports") {
  const auto parsed = fiacre::parse(R"(
const N: nat is 2 * 3
type cell is 0..N - 1
type cells is array N of cell
channel link is in 0..3 # bool
process P [p: link] (c: cell) is states s from s wait [N, 2 * N[; to s
)");
  CHECK(parsed.problems.empty());
  CHECK(parsed.program.types[0].type.high == 5);
  CHECK(parsed.program.types[1].type.size == 6);
  const auto& process = parsed.program.processes[0];
  CHECK(process.ports[0].in);
  CHECK(process.ports[0].values.size() == 2);
  const auto& wait = process.transitions[0].statement.children[0];
  CHECK(fiacre::printInterval(wait.interval) == "[6,12[");
}

TEST_CASE("instances synchronise on what is said") {
  const auto instances = [](std::string_view composition) {
    const auto text = "component C is port a, b: sync " + std::string(composition);
    const auto parsed = fiacre::parse(text);
    REQUIRE(problemsOf(parsed, text) == "");
    return parsed.program.components[0].instances;
  };
  using Ports = std::vector<std::string>;
  CHECK_FALSE(instances("par * in P[a] || Q[b] end")[1].synchronised);
  CHECK(instances("par P[a] || Q[b] end")[1].synchronised == Ports{});
  CHECK(instances("par a, b in P[a] || Q[b] end")[1].synchronised == Ports{"a", "b"});
  CHECK(instances("par a -> P[a] || Q[b] end")[0].synchronised == Ports{"a"});
  CHECK(instances("par a -> P[a] || Q[b] end")[1].synchronised == Ports{});
}

TEST_CASE("a composition within a composition, with ports of its own") {
  constexpr std::string_view text = R"(component C is
port a: sync, b: sync
par
    a -> par * in
        P [a]
    ||  par
            P [a]
        ||  b -> Q [a, b]
        end
    end
||  Q [a, b]
end

C
)";
  const auto parsed = fiacre::parse(text);
  CHECK(problemsOf(parsed, text) == "");
  const auto& parts = parsed.program.components[0].instances;
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].synchronised == std::vector<std::string>{"a"});
  REQUIRE(parts[0].parts.size() == 2);
  CHECK_FALSE(parts[0].parts[0].synchronised);
  CHECK(parts[0].parts[1].parts[1].process == "Q");
  CHECK(fiacre::print(parsed.program) == text);
}

TEST_CASE("probes and observers are read as they are printed") {
  constexpr std::string_view text = R"(component main is
par * in
    P
end

component watch is
port seen: sync in [0,0] is (main/1/value x) and (not (main/1/state s)), t: sync in [2,2],
     left: sync is leave (main/1/state s)
par * in
    W [seen, t, left]
end

main

watch > main

property p is absent watch/1/state late
assert p
)";
  const auto parsed = fiacre::parse(text);
  CHECK(problemsOf(parsed, text) == "");
  REQUIRE(parsed.program.observers.size() == 1);
  CHECK(parsed.program.observers[0].model == "main");
  const auto& ports = parsed.program.components[1].ports;
  REQUIRE(ports.size() == 3);
  CHECK(ports[0].probe);
  CHECK_FALSE(ports[1].probe);
  CHECK(ports[0].probe->operands[0].observer.empty());
  CHECK(parsed.program.properties[0].pattern.operands[0].observer == "watch");
  CHECK(fiacre::print(parsed.program) == text);
}

TEST_CASE("a probe stands where a component declares a port") {
  CHECK(problemsOf("process P [a: sync is main/1/state s] is states s") ==
        "`is`: a probe must be declared after `port` in a component\n");
  CHECK(problemsOf("component C is par P end C o > C property p is absent x/1/state s") ==
        "`x`: the path begins with `x`, but the model is `C`\n");
}

TEST_CASE("words of patterns are names elsewhere, and formulas of time have names, too") {
  constexpr std::string_view text = R"(
function state (value: nat, always: bool): bool is begin return value > 2 and always end
process P is states within, tag var read: nat from within read := 3; #present; to tag
component main is par * in P end
main
property write is ltl (main/1/state within)
property p is ltl [] (write => <> main/1/value (state(read, true)))
)";
  const auto parsed = fiacre::parse(text);
  CHECK(problemsOf(parsed, text) == "");
  REQUIRE(parsed.program.properties.size() == 2);
  CHECK(fiacre::printPattern(parsed.program.properties[1].pattern, "main") ==
        "ltl [] ((main/1/state within) => (<> (main/1/value state(read, true))))");
}

TEST_CASE("declarations may stand behind the model's name") {
  constexpr std::string_view text =
      "process P is states s from s null; to s component main is par P end main "
      "type bit is 0..1 process W is states s component watch is par W end watch > main";
  CHECK(problemsOf(text) == "");
  CHECK(fiacre::parse(text).program.processes.size() == 2);
}

TEST_CASE("properties are read, and formulas that others name") {
  constexpr std::string_view text = R"(
process P is states s, t var x: nat from s to t
component main is par * in P || P end
main
property both is main/1/state s and main/2/value x = 3
property seldom is ltl [] (both => <> main/1/tag done)
property soon is main/1/state s leadsto main/2/event p within [0,3[
property far is absent (enter main/1/state t) after main/2/state s for interval ]1,2]
assert seldom
prove far
)";
  const auto parsed = fiacre::parse(text);
  CHECK(problemsOf(parsed, text) == "");
  REQUIRE(parsed.program.properties.size() == 3);
  CHECK(parsed.program.properties[0].asserted);
  CHECK_FALSE(parsed.program.properties[1].asserted);
  CHECK(parsed.program.properties[2].asserted);
  CHECK(fiacre::printPattern(parsed.program.properties[0].pattern, "main") ==
        "ltl [] (((main/1/state s) and (main/2/value (x = 3))) => (<> (main/1/tag done)))");
  CHECK(parsed.program.properties[1].pattern.within->upperOpen);
}

TEST_CASE("every scope of a pattern is read as it is printed") {
  for (const std::string pattern :
       {"(main/1/state s) leadsto first (main/1/state t) within [1,2]",
        "absent main/1/state s between main/1/state t and main/2/state t",
        "present main/1/state s after main/1/state t until main/2/state t",
        "absent main/1/state s after ((main/1/state t) or (main/2/state t)) until main/2/state s",
        "absent main/1/state s before main/1/state t for duration 3",
        "present main/1/state s lasting 4", "ltl (main/1/state s) until (main/1/state t)"}) {
    const auto parsed = fiacre::parse("main\nproperty p is " + pattern + "\nassert p");
    CHECK(problemsOf("main\nproperty p is " + pattern + "\nassert p") == "");
    REQUIRE(parsed.program.properties.size() == 1);
    CHECK(fiacre::printPattern(parsed.program.properties[0].pattern, "main") == pattern);
  }
  const auto brief = fiacre::parse("main\nproperty p is ltl (main/1/state s) U (main/1/state t)");
  CHECK(brief.program.properties[0].pattern.ltl.kind == fiacre::LtlKind::Until);
}

TEST_CASE("a mistake is told at its place, and the rest is read") {
  CHECK(problemsOf("process P is states s from s wait [0,0] to s") ==
        "`to`: `;` is missing before `to`\n");
  CHECK(problemsOf("process P is states s from s to from s loop\nprocess Q is states t") ==
        "`from`: the name of a state is missing: `from` is a keyword of Fiacre\n");
  CHECK(problemsOf("const c: nat is\ntype t is bool") ==
        "`type`: an expression is missing: `type` is a keyword of Fiacre\n");
  CHECK(problemsOf("process P is states s from s wait [0.5,1]; to s") ==
        "`.`: times must be integers: choose a smaller unit, and name it in a comment\n");
  CHECK(problemsOf("/* no end") == "`/*`: the comment has no end: `*/` is missing\n");
  CHECK(problemsOf("type a is 0..n") == "`n`: the upper bound is not a number known here\n");
  CHECK(problemsOf("@@ type a is bool") == "`@@`: unexpected character\n");
  const auto parsed = fiacre::parse("process P is states s, t from s to; from t to s");
  CHECK(parsed.program.processes.at(0).transitions.size() == 1);
}

TEST_CASE("of very many mistakes the first thousand are told") {
  const auto problems = fiacre::parse(repeated("@ ", 5000)).problems;
  REQUIRE(problems.size() == 1001);
  CHECK(problems[999].message == "unexpected character");
  CHECK(problems[1000].message == "4000 more errors from here on");
  CHECK(problems[1000].begin == 2000);
}

TEST_CASE("an origin is the text's own range") {
  constexpr std::string_view text = "process P is states s from s x := 1; to s";
  const auto parsed = fiacre::parse(text);
  const auto& statement = parsed.program.processes[0].transitions[0].statement.children[0];
  const auto& origin = parsed.provenance.origins[statement.origin];
  CHECK(text.substr(origin.begin, origin.end - origin.begin) == "x := 1");
  CHECK(origin.description == "x := 1");
  CHECK(origin.actor == "P");
}

TEST_CASE("whatever the text, reading ends") {
  const auto text = fiacre::print(test::randomModel(7));
  for (std::size_t length = 0; length < text.size(); length += 7)
    (void)fiacre::parse(text.substr(0, length));
  for (std::size_t at = 0; at + 9 < text.size(); at += 11)
    (void)fiacre::parse(text.substr(0, at) + text.substr(at + 9));
  for (const auto* part : {"(", "[", "if x then ", "select ", "not ", "{|", "-", "par "})
    CHECK_FALSE(fiacre::parse("process P is states s from s x := " + repeated(part, 100'000))
                    .problems.empty());
}

TEST_CASE("patterns without scope and times are joined, by their names, too") {
  const auto joined = [](const std::string& pattern) {
    const auto text = "process P is states a, b from a to b P property q is mortal P/state b "
                      "property p is " +
                      pattern + " assert p";
    const auto parsed = fiacre::parse(text);
    REQUIRE(problemsOf(parsed, text) == "");
    REQUIRE(parsed.program.properties.size() == 2);
    CHECK(parsed.program.properties[1].asserted);
    return fiacre::printPattern(parsed.program.properties[1].pattern, "P");
  };
  CHECK(joined("(absent P/state a) and (present P/state b)") ==
        "ltl ([] (not (P/state a))) and (<> (P/state b))");
  CHECK(joined("not (always P/state a)") == "ltl not ([] (P/state a))");
  CHECK(joined("not infinitelyoften P/state a") == "ltl not ([] (<> (P/state a)))");
  CHECK(joined("(P/state a leadsto P/state b) => q") ==
        "ltl ([] ((P/state a) => (<> (P/state b)))) => (<> ([] (not (P/state b))))");
  CHECK(
      joined("((P/state a) precedes (P/state b)) or (ltl () P/state b)") ==
      "ltl (((not (P/state b)) until (P/state a)) or ([] (not (P/state b)))) or (() (P/state b))");
}

TEST_CASE("a scope or a time that comes twice is a mistake, and so is one that is joined") {
  const auto problems = [](const std::string& pattern) {
    return problemsOf("process P is states a, b from a to b\nproperty p is " + pattern + "\nP");
  };
  CHECK(problems("absent P/state a after P/state b until P/state a within [0,1]") == "");
  CHECK(problems("absent P/state a after P/state b after P/state a") ==
        "`after`: duplicate `after` in one pattern\n");
  CHECK(problems("absent P/state a before P/state b before P/state a") ==
        "`before`: duplicate `before` in one pattern\n");
  CHECK(problems("absent P/state a within [0,1] within [0,2]") ==
        "`within`: duplicate `within` in one pattern\n");
  CHECK(problems("absent P/state a for duration 1 for duration 2") ==
        "`for`: duplicate `for` in one pattern\n");
  const auto apart = "this pattern cannot be combined with others";
  CHECK_THAT(problems("(absent P/state a within [0,1]) and (absent P/state b)"),
             Catch::Contains("`absent`: " + std::string(apart)));
  CHECK_THAT(problems("not deadlockfree"), Catch::Contains(apart));
  CHECK_THAT(problems("(P/state a leadsto P/state b within [0,1]) and (absent P/state b)"),
             Catch::Contains("`P`: " + std::string(apart)));
}

} // namespace proskill::test::parse_test
