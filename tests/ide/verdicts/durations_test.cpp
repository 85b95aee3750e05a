#include "ide/features/hover.h"
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

} // namespace proskill::test::durations_test
