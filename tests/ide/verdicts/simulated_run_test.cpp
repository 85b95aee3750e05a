#include "ide/verdicts/simulated_run.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

ide::SimulatedRun runOf(const std::string& text) {
  const auto program = test::programOfText(text);
  auto model = codegen::generate(program);
  REQUIRE(model.has_value());
  auto run = ide::SimulatedRun::start(std::move(*model));
  REQUIRE(run.has_value());
  return std::move(*run);
}

/// Takes the choice with this description.
void choose(ide::SimulatedRun& run, const std::string& actor, const std::string& description,
            verify::When when = verify::When::Early) {
  const auto choices = run.choices();
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (choices[i].actor == actor && choices[i].description.starts_with(description))
      return run.take(i, when);
  FAIL("nothing reads " << actor << ' ' << description);
}

std::vector<ide::ChosenStep> stepsOf(const ide::SimulatedRun& run) {
  std::vector<ide::ChosenStep> steps;
  for (const auto& step : run.trace().steps)
    steps.push_back({step.actor, step.description, step.transitions});
  return steps;
}

const std::string kLitRun = R"((defsv lamp :states (On Off) :init Off :transitions :all)
(defskill light :time_interval [2,5] :action (a) :success lit (:effects (lamp On)) :failure broken)
(defskill mission :success done :body ((light) (success done)))
)";

/// Up to the moment at which the action runs.
ide::SimulatedRun running(const std::string& text = kLitRun) {
  auto run = runOf(text);
  while (run.choices().front().latest && run.choices().front().latest->seconds.numerator == 0)
    run.take(0);
  return run;
}

} // namespace

TEST_CASE("a run offers what may happen, and goes where somebody takes it") {
  auto run = running();
  CHECK(run.choices().size() == 2);
  choose(run, "light", "succeeds");
  CHECK(run.values().at("lamp") == "On");
  CHECK(syntax::toString(run.trace().steps.back().date) == "2");
  CHECK(run.undo());
  CHECK(run.values().at("lamp") == "Off");
  choose(run, "light", "fails");
  CHECK(run.values().at("lamp") == "Off");
  CHECK(run.values().at("light.status") == "failure");
}

TEST_CASE("a step can come as late as it may") {
  auto run = running();
  choose(run, "light", "succeeds", verify::When::Late);
  CHECK(syntax::toString(run.trace().steps.back().date) == "5");
}

TEST_CASE("a run is taken again step by step, and in a program that was edited elsewhere") {
  auto run = running();
  choose(run, "light", "succeeds");
  while (!run.choices().empty()) run.take(0);
  const auto steps = stepsOf(run);
  auto again = runOf("(defsv fan :states (Still Turning) :init Still)\n\n" + kLitRun);
  CHECK_FALSE(again.follow(steps));
  CHECK(again.trace().steps.size() == steps.size());
  CHECK(again.values().at("lamp") == "On");
  // After the last common step: takes the rest back, and continues differently.
  CHECK_FALSE(again.follow(std::span(steps).first(2)));
  CHECK(again.trace().steps.size() == 2);
  CHECK_FALSE(again.follow(steps));
  CHECK(again.trace().steps.size() == steps.size());
}

TEST_CASE("a step that is not possible any more is named, and the run ends before it") {
  auto run = running();
  choose(run, "light", "succeeds");
  const auto steps = stepsOf(run);
  auto text = kLitRun;
  text.replace(text.find(":success lit (:effects (lamp On))"), 33,
               ":success shines (:effects (lamp On))");
  auto edited = runOf(text);
  const auto missing = edited.follow(steps);
  REQUIRE(missing);
  CHECK(missing->index == steps.size() - 1);
  CHECK(missing->why == "now `light` succeeds with `shines`");
  CHECK(edited.trace().steps.size() == steps.size() - 1);
}

TEST_CASE("what a run was expected to end with is compared, also where there is no such variable") {
  auto run = running();
  choose(run, "light", "fails");
  CHECK(ide::unmet(run, {{"light.status", "failure"}, {"lamp", "Off"}}).empty());
  const auto unmet = ide::unmet(run, {{"lamp", "On"}, {"fan", "Still"}});
  REQUIRE(unmet.size() == 2);
  CHECK(unmet[0].variable == "fan");
  CHECK(unmet[0].actual.empty());
  CHECK(unmet[1].expected == "On");
  CHECK(unmet[1].actual == "Off");
}

TEST_CASE("at the end nothing is offered, and nothing more can be taken") {
  auto run = runOf(kLitRun);
  for (int i = 0; i < 100 && !run.choices().empty(); ++i) run.take(0);
  CHECK(run.choices().empty());
  auto steps = stepsOf(run);
  steps.push_back({"light", "starts", {}});
  const auto missing = run.follow(steps);
  REQUIRE(missing);
  CHECK(missing->why == "no step is possible any more");
}
