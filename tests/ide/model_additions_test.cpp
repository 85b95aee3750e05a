#include "ide/verdicts/model_additions.h"

#include "ide/verdicts/verification.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;

namespace {

constexpr auto kLamp = R"(
(defsv lamp :states (On Off) :init Off :transitions :all)
(defevent switch_on :effects (lamp On))
(defevent switch_off :effects (lamp Off))
(defskill wait_for_light :time_interval [1,2] :action (look)
  :success seen (:postcondition (lamp On)))
)";

struct Case {
  explicit Case(const std::string& text = kLamp) : program(test::programOfText(text)) {}

  analysis::Program program;
  codegen::Model model = codegen::generate(program).value();

  /// The errors in a text, each with the text it is about.
  std::string environment(const std::string& text) {
    return told(ide::replaceEnvironment(model, program, "env.fcr", text), text);
  }
  std::string properties(const std::string& text, const std::string& file = "p.fcr") {
    return told(ide::addProperties(model, program, file, text), text);
  }

  [[nodiscard]] std::string verdict(const std::string& name) const {
    const auto report = ide::verifyModel(model, {name}, {});
    if (!report) return report.error().message;
    if (report->rows.size() != 1) return "no such property";
    switch (report->rows[0].verdict) {
    case ide::Verdict::Violated: return "violated";
    case ide::Verdict::Inconclusive: return "inconclusive";
    default: return "holds";
    }
  }

private:
  static std::string told(const std::vector<syntax::Diagnostic>& found, const std::string& text) {
    std::string all;
    for (const auto& each : found)
      all += "`" + text.substr(each.location.range.begin, each.location.range.length()) +
             "`: " + each.message + "\n";
    return all;
  }
};

constexpr auto kOnOnly = "process on_only [switch_on: sync] is\nstates dark, light\n\n"
                         "from dark\n    switch_on;\n    to light\n";
constexpr auto kLight = "property light is absent model/value lamp = On\nassert light\n"
                        "property dark_again is absent model/on_only/state light\n"
                        "assert dark_again\n";

} // namespace

TEST_CASE("an environment of the user's own takes the place of the generated one") {
  Case lamp;
  REQUIRE(lamp.environment("process never [switch_on: sync] is\nstates idle\n") == "");
  REQUIRE(lamp.properties("property light is absent model/value lamp = On\nassert light\n") == "");
  CHECK(lamp.verdict("light") == "holds");

  Case other;
  REQUIRE(other.environment(kOnOnly) == "");
  REQUIRE(other.properties(kLight) == "");
  CHECK(other.verdict("light") == "violated");
  CHECK(other.verdict("dark_again") == "violated");
}

TEST_CASE("an environment begins when the initial values have been chosen") {
  std::string text = kLamp;
  text.replace(text.find(":init Off"), 9, ":init (Off On)");
  Case lamp(text);
  REQUIRE(lamp.environment("process never [switch_on: sync] is\nstates idle\n") == "");
  REQUIRE(lamp.properties("property light is absent model/value lamp = On\nassert light\n") == "");
  CHECK(lamp.verdict("light") == "violated");
  Case eager(text);
  REQUIRE(eager.environment("process off [switch_off: sync] is\nstates a, b\n"
                            "from a switch_off; to b\n") == "");
  REQUIRE(eager.properties("property p is absent (model/off/state b) and (model/value lamp = On)"
                           "\nassert p\n") == "");
  CHECK(eager.verdict("p") == "holds");
}

TEST_CASE("what an environment has no port for never happens, unless it comes by itself") {
  Case lamp;
  REQUIRE(lamp.environment("process on_off [switch_on: sync] is\nstates a, b\n"
                           "from a switch_on; to b\n") == "");
  REQUIRE(lamp.properties("property never_off is absent model/event switch_off\n"
                          "assert never_off\n") == "");
  CHECK(lamp.verdict("never_off") == "holds");
  std::string text = kLamp;
  text.replace(text.find("switch_off :effects"), 19, "switch_off :every [1,5] :effects");
  Case blinking(text);
  const std::string named = "process on_off [switch_off: sync] is\nstates a\n"
                            "from a switch_off; to a\n";
  CHECK(blinking.environment(named) ==
        "`switch_off`: process on_off: `switch_off` has `:every` and comes by itself\n");
  Case dark(text);
  REQUIRE(dark.environment("process on_only [switch_on: sync] is\nstates a, b\n"
                           "from a switch_on; to b\n") == "");
  REQUIRE(dark.properties("property never_off is absent model/event switch_off\n"
                          "assert never_off\n") == "");
  CHECK(dark.verdict("never_off") == "violated");
}

TEST_CASE("an environment sees the model's variables, and takes its time") {
  Case lamp;
  REQUIRE(
      lamp.environment("process e [switch_on: sync, switch_off: sync] (&lamp: sv_lamp) is\n"
                       "states a, b\nfrom a wait [3,4]; to b\n"
                       "from b select on lamp = Off; switch_on [] on lamp = On; switch_off end; "
                       "to a\n") == "");
  REQUIRE(lamp.properties("property p is absent model/e/state b\nassert p\n") == "");
  CHECK(lamp.verdict("p") == "violated");
}

TEST_CASE("mistakes in an environment are told at its lines") {
  const auto wrong = [](const std::string& text) { return Case().environment(text); };
  CHECK(wrong("process e [ring: sync] is states a from a ring; to a") ==
        "`ring`: process e: the program has no event or interrupt `ring`: there are `switch_on`, "
        "`switch_off`\n");
  CHECK(wrong("process e (&moon: nat) is states a") ==
        "`moon`: process e: the model has no variable `moon`\n");
  CHECK(wrong("process e (lamp: sv_lamp) is states a") ==
        "`lamp`: process e: a variable of the model is passed by reference: `&lamp`\n");
  CHECK(wrong("process e [switch_on: sync] is states a\nfrom a switch_on; to b") ==
        "`b`: process e, state a: the state `b` is not declared\n");
  CHECK(wrong("process e (&lamp: sv_lamp) is states a\nfrom a lamp := 3; to a").find("3") !=
        std::string::npos);
  CHECK(wrong("process a is states s process b is states s") ==
        "``: environment: which process is it? Write its name at the end of the text\n");
  CHECK(wrong("process e is states a from") != "");
}

TEST_CASE("an environment may consist of several processes") {
  Case lamp;
  REQUIRE(lamp.environment("process p [x: sync] is states a from a x; to a\n"
                           "component both [switch_on: sync, switch_off: sync] is\n"
                           "par p [switch_on] || p [switch_off] end\n") == "");
  CHECK(lamp.properties("property p is absent model/value lamp = On\nassert p") == "");
  CHECK(lamp.verdict("p") == "violated");
}

TEST_CASE("properties have the program's names") {
  Case lamp;
  REQUIRE(lamp.properties("property seen is absent model/value wait_for_light.status = success\n"
                          "assert seen\n"
                          "property twice is absent (model/value lamp = On) and (model/value lamp "
                          "= Off)\nassert twice") == "");
  CHECK(lamp.verdict("seen") == "violated");
  CHECK(lamp.verdict("twice") == "holds");
}

TEST_CASE("mistakes in properties are told at their lines") {
  const auto wrong = [](const std::string& text) { return Case().properties(text); };
  CHECK(wrong("property p is absent m/value lamp = On")
            .starts_with("`m`: properties: the model is `"));
  CHECK(wrong("property p is absent model/1/state nowhere\nassert p") != "");
  CHECK(wrong("property p is absent model/nobody/state x\nassert p")
            .find("no part of the model is called `nobody`") != std::string::npos);
  CHECK(wrong("process p is states s") ==
        "`process p is states s`: properties: only properties can be added to a model\n");
}

TEST_CASE("a formula alone is a property that is called as its file") {
  Case lamp;
  REQUIRE(lamp.properties("[] (not (model/value lamp = On))", "no-light.ltl") == "");
  const auto& check = lamp.model.checks.back();
  CHECK(check.name == "no_light");
  CHECK(lamp.model.fiacre.properties[check.property].pattern.kind == fiacre::PatternKind::Ltl);
}
