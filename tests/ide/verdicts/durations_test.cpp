#include "ide/features/hover.h"
#include "ide/features/inlay_hints.h"
#include "ide/features/lenses.h"
#include "ide/verdicts/durations.h"
#include "tests/ide/marked_program.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

namespace proskill::test::durations_test {

using test::MarkedProgram;

namespace {

/// By skill: its duration as text.
std::map<std::string, std::string> durations(const std::string& text,
                                             std::optional<double> seconds = {}) {
  const auto program = test::programOfText(text);
  const auto asked = ide::askForDurations(codegen::generate(program, {}).value());
  verify::Options options;
  options.limits.seconds = seconds;
  std::map<std::string, std::string> all;
  for (const auto& each : ide::measureDurations(asked, options))
    all[each.skill] = ide::durationText(each);
  return all;
}

const std::string kDrive = "(defsv door :states (Open Shut) :init Open :transitions :all)\n"
                           "(defskill drive :time_interval [2,5[ :action (go) :failure lost)\n";

ide::Verdicts measured(const MarkedProgram& program, std::vector<ide::SkillDuration> durations) {
  auto verdicts = std::make_shared<ide::ProgramVerdicts>();
  verdicts->program = program.view().owner;
  ide::PropertyVerdict verdict;
  verdict.subject = verdict.name = "drive";
  verdict.verdict = ide::Verdict::Holds;
  verdicts->properties = {verdict};
  verdicts->durations = std::move(durations);
  return {{program.view().program().files.front().path, verdicts}};
}

ide::MeasuredTime time(std::int64_t seconds) { return {true, true, {{seconds, 1}, false}}; }

} // namespace

TEST_CASE("durations are those of the runs of the program, not of the interval alone") {
  const auto found =
      durations(kDrive + "(defskill wash :time_interval [1,9] :action (wash))\n"
                         "(defskill shut :action (shut))\n"
                         "(defskill unused :precondition (never (door Shut)) :action (x))\n"
                         "(defskill m :body ((drive) (race ((wash)) ((^ 4))) (shut) (unused)))\n");
  CHECK(found.at("drive") == "2 to less than 5 s");
  CHECK(found.at("shut") == "at least 0 s, with no upper bound");
  CHECK(found.at("unused") == "never runs");
  CHECK(found.at("m") == "at least 3 s, with no upper bound");
}

TEST_CASE("a skill that is stopped takes less time than its interval says") {
  const auto found = durations(kDrive + "(defskill wash :time_interval [3,9] :action (wash))\n"
                                        "(defskill m :body ((race ((wash)) ((^ 4)))))\n");
  CHECK(found.at("wash") == "3 to 4 s");
  CHECK(found.at("m") == "3 to 4 s");
  CHECK(durations(kDrive + "(defskill m :body ((^ 7)))").at("m") == "7 s");
}

TEST_CASE("a skill that never ends has no shortest duration") {
  CHECK(durations(kDrive + "(defskill m :body ((while true (drive))))").at("m") == "never ends");
  CHECK(durations(kDrive + "(defskill m :body ((^ (door Shut))))").at("m") == "never ends");
}

TEST_CASE("what no time is left to measure is not known") {
  const auto found = durations(kDrive + "(defskill m :body ((drive)))", 0);
  CHECK(found.at("drive").empty());
  CHECK(found.at("m").empty());
}

TEST_CASE("hovers and lenses show the duration of a skill, only for these texts") {
  const MarkedProgram program(kDrive + "(defskill m :body ((dri^ve)))");
  const auto known = measured(program, {{"drive", time(2), time(5)}, {"m", time(2), {}}});
  const auto shown = ide::hover(program.view(), program.at(), known);
  REQUIRE(shown);
  CHECK(shown->text.markdown().ends_with("Takes 2 to 5 s, over all runs of the program."));
  const auto without = ide::hover(program.view(), program.at(), measured(program, {}));
  CHECK(without->text.markdown().find("Takes") == std::string::npos);
  std::vector<std::string> titles;
  for (const auto& lens : ide::lenses(program.view(), known))
    if (lens.kind == ide::LensKind::Verdicts) titles.push_back(lens.title);
  CHECK(titles == std::vector<std::string>{"✓ 1 good · 2 to 5 s"});

  const MarkedProgram edited(kDrive + "(defskill m :body ((dri^ve) (drive)))");
  CHECK(ide::hover(edited.view(), edited.at(), known)->text.markdown().find("Takes") ==
        std::string::npos);
  for (const auto& lens : ide::lenses(edited.view(), known))
    CHECK(lens.title.find("2 to 5 s") == std::string::npos);
}

TEST_CASE("neither lenses nor hints show that a skill may take any time") {
  const MarkedProgram program("(defskill drive :body ((^ 2)))");
  const ide::MeasuredTime unbounded{true, false, {}};
  const auto lensAndHint = [&](std::optional<ide::MeasuredTime> shortest,
                               std::optional<ide::MeasuredTime> longest) {
    const auto known = measured(program, {{"drive", shortest, longest}});
    const auto& view = program.view();
    std::vector<std::string> shown{ide::lenses(view, known).front().title};
    for (const auto& hint : ide::inlayHints(view, {0, 40}, known)) shown.push_back(hint.label);
    return shown;
  };
  using Shown = std::vector<std::string>;
  CHECK(lensAndHint(time(0), unbounded) == Shown{"✓ 1 good"});
  CHECK(lensAndHint(time(1), unbounded) ==
        Shown{"✓ 1 good · at least 1 s, with no upper bound", "at least 1 s, with no upper bound"});
  CHECK(lensAndHint(time(0), time(3)) == Shown{"✓ 1 good · 0 to 3 s", "0 to 3 s"});
  CHECK(lensAndHint(time(0), ide::MeasuredTime{false, true, {}}) ==
        Shown{"✓ 1 good · never runs", "never runs"});
  CHECK(lensAndHint(ide::MeasuredTime{false, true, {}}, unbounded) ==
        Shown{"✓ 1 good · never ends", "never ends"});
  // a limit was met: the hint is computed from the body
  CHECK(lensAndHint(std::nullopt, unbounded) == Shown{"✓ 1 good", "2 s"});
  CHECK(lensAndHint(time(0), std::nullopt) == Shown{"✓ 1 good", "2 s"});
  CHECK(lensAndHint(std::nullopt, std::nullopt) == Shown{"✓ 1 good", "2 s"});
}

TEST_CASE("a hint shows a measured duration also where none can be computed") {
  const MarkedProgram program("(defskill drive :body ((^ (door Open))))\n"
                              "(defsv door :states (Open Shut) :init (Open Shut))");
  const auto hints = [&](const ide::Verdicts& known) {
    return ide::inlayHints(program.view(), {0, 20}, known);
  };
  CHECK(hints({}).empty());
  const auto known = measured(program, {{"drive", time(1), time(3)}});
  REQUIRE(hints(known).size() == 1);
  CHECK(hints(known).front().label == "1 to 3 s");
}

} // namespace proskill::test::durations_test
