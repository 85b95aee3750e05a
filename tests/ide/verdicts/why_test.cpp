#include "ide/verdicts/verification.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

/// The trace of a property of a program.
ide::Trace traceOf(const std::string& text, const std::string& property) {
  const auto program = test::programOfText(text);
  const auto model = codegen::generate(program);
  REQUIRE(model.has_value());
  auto report = ide::verifyModel(*model, {property}, {});
  REQUIRE(report.has_value());
  REQUIRE(report->rows.size() == 1);
  return report->rows[0].trace.value();
}

const ide::TraceStep& stepThat(const ide::Trace& trace, const std::string& description) {
  for (const auto& step : trace.steps)
    if (step.description.find(description) != std::string::npos) return step;
  FAIL("no step that " << description);
  return trace.steps.front();
}

const std::string kRobot = R"((defsv energy :init 3 :min 0 :max 4)
(defsv place :states (Dock Field) :init Dock :transitions :all)
(defsv lid :states (Open Shut) :init Shut :transitions ((Shut Open)))
(defskill charge :precondition (at_dock (place Dock) low (< energy 3)) :time_interval [1,2] :success ok)
(defskill drill :time_interval [2,3] :success done (:effects ((energy (- energy 2)) (place Field))))
(defskill close :time_interval [1,1] :success shut (:effects (lid Shut)))
(defskill open :time_interval [1,1] :success open (:effects (lid Open)))
)";

} // namespace

TEST_CASE("a number out of its bounds is told with the sum that it is") {
  const auto trace = traceOf(
      kRobot + "(defskill mission :success done :body ((drill) (drill) (success done)))", "energy");
  CHECK(trace.steps.back().why == "`energy` 1 − 2 = −1 is below `:min` 0");
  CHECK(trace.summary.ends_with("`energy` 1 − 2 = −1 is below `:min` 0."));
  CHECK(trace.summary.starts_with("In step "));
  CHECK(stepThat(trace, "succeeds").why.starts_with("2 to 3 s after step "));
}

TEST_CASE("a refusal is told with the condition that is false, and since when") {
  const auto trace =
      traceOf(kRobot + "(defskill mission :success done :body ((drill) (charge) (success done)))",
              "mission.never_refused");
  const auto& refused = stepThat(trace, "is refused");
  // That `low` is true is not a reason.
  CHECK(refused.why.starts_with("`at_dock (place Dock)` is false (`place` is Field since step "));
  CHECK(refused.why.find("energy") == std::string::npos);
  CHECK(trace.summary.find("`at_dock (place Dock)` is false (`place` is Field") !=
        std::string::npos);
}

TEST_CASE("a move that is not allowed is told with the value that it starts from") {
  const auto trace = traceOf(
      kRobot + "(defskill mission :success done :body ((open) (close) (success done)))", "lid");
  CHECK(trace.steps.back().why.starts_with("`lid` is Open since step "));
  CHECK(trace.steps.back().why.ends_with("no transition leads from there to Shut"));
}

TEST_CASE("who is stopped is told by whom") {
  const auto trace = traceOf(kRobot + R"((defsv alarm :states (Off On) :init Off :transitions :all)
(defevent rings :effects (alarm On))
(defskill walk :time_interval [5,9] :interrupt () :success there)
(defskill mission :invariant (calm (:guard (alarm Off))) :success done :body ((walk) (success done)))
(defenvironment world :body ((^ 1) (emit rings) (^ 9)))
(defproperty stopped (reachable (ended walk interrupted)))
)",
                             "stopped");
  const auto& stopped = stepThat(trace, "is interrupted");
  CHECK(stopped.actor == "walk");
  CHECK(stopped.why.find("mission finds its invariant `calm` violated: `(alarm Off)` is "
                         "false (`alarm` is On since step ") != std::string::npos);
}

TEST_CASE("a composite skill notices its failed guard in one step, and ends in another") {
  const auto trace = traceOf(R"((defsv alarm :states (Off On) :init Off)
(defsv noted :init 0 :min 0 :max 1)
(defskill mission
  :invariant (calm (:guard (alarm Off) :effects (noted 1)))
  :body ((^ 1) (set (alarm On)) (^ 1)))
)",
                             "mission.invariant_may_fail.calm");
  std::vector<std::string> last;
  for (const auto& step : trace.steps)
    if (step.description.find("invariant") != std::string::npos) last.push_back(step.description);
  CHECK(last == std::vector<std::string>{"finds its invariant `calm` violated",
                                         "ends because of its invariant `calm`"});
}

TEST_CASE("what the mission does not need is said not to matter") {
  const auto trace = traceOf(kRobot + R"((defevent noise :effects (place Dock))
(defskill idle :monitor t :success ok :body ((^ 1) (set (lid Open)) (success ok)))
(defskill mission :success done :body ((drill) (drill) (success done)))
)",
                             "energy");
  CHECK(trace.steps.back().relevant);
  for (const auto& step : trace.steps)
    if (step.actor == "idle") CHECK_FALSE(step.relevant);
}

TEST_CASE("where nothing is possible any more, it is said who waits for what") {
  const auto trace = traceOf(kRobot + R"(
(defskill mission :body ((drill) (// ((^ (lid Open)) (drill)) ((charge) (^ (place Dock))))))
(defskill guard :monitor t :body ((while true (^ (energy 0)) (drill.interrupt))))
)",
                             "program.no_deadlock");
  CHECK(trace.summary.find("the mission has not ended: `mission branch 1` waits for `(lid Open)`; "
                           "`mission branch 2` waits for `(place Dock)`") != std::string::npos);
  CHECK(trace.summary.find("`guard` waits for `(energy 0)`") != std::string::npos);
  CHECK(trace.summary.find("`mission` waits for the end of its parallel branches") !=
        std::string::npos);
  CHECK(trace.summary.find("`close`") == std::string::npos); // nobody waits for it
}

TEST_CASE("a called skill that waits for a resource names who has it") {
  const auto trace = traceOf(R"(
(defsv lamp :states (On Off) :init Off)
(defresource wheels) (defresource arm)
(defskill drive :resources (wheels) :action (go))
(defskill grip :resources (arm) :action (close))
(defskill fetch :resources (wheels) :body ((grip)))
(defskill carry :resources (arm) :body ((drive)))
(defskill mission :body ((// ((fetch)) ((carry)))))
)",
                             "program.no_deadlock");
  INFO(trace.summary);
  CHECK(trace.summary.find("has not ended: `drive` waits for the resource `wheels`, which `fetch` "
                           "has; `grip` waits for the resource `arm`, which `carry` has; ") !=
        std::string::npos);
  CHECK(trace.summary.find("`fetch` waits for the end of `grip`") != std::string::npos);
  CHECK(trace.summary.find("`lamp`") == std::string::npos);
}

TEST_CASE("a monitor waits for its precondition, and all who share a resource are named") {
  const auto trace = traceOf(R"(
(defsv lamp :states (On Off) :init Off)
(defresource radio :capacity 2)
(defskill report :monitor always :precondition (lit (lamp On)) :body ((set (lamp Off))))
(defskill talk :resources (radio) :body ((^ (lamp On))))
(defskill sing :resources (radio) :body ((^ (lamp On))))
(defskill call :resources (radio) :action (ring))
(defskill mission :body ((// ((talk)) ((sing)) ((^ 1) (call)))))
)",
                             "program.no_deadlock");
  INFO(trace.summary);
  CHECK(trace.summary.find("`report` waits for `(lamp On)`") != std::string::npos);
  CHECK(trace.summary.find("`lamp`") == std::string::npos);
  CHECK(trace.summary.find("`call` waits for the resource `radio`, which `talk` and `sing` have") !=
        std::string::npos);
}

TEST_CASE("a property of runs is told with what does not come, and that nothing happens any more") {
  const std::string lamp = R"((defsv lamp :states (On Off) :init Off :transitions :all)
(defskill light :time_interval [2,5] :action (a) :success lit (:effects (lamp On)) :failure broken)
(defskill mission :success done :body ((light) (success done)))
)";
  const auto summary = [&](const std::string& property) {
    return traceOf(lamp + "(defproperty p " + property + ")", "p").summary;
  };
  CHECK(summary("(present (lamp On))")
            .ends_with("nothing happens any more: `(lamp On)` does not become true."));
  CHECK(summary("(leadsto (running light) (lamp On))")
            .ends_with("nothing happens any more: `(lamp On)` does not follow `(running light)`."));
  CHECK(summary("(leadsto (running light) (lamp On) :within [0,60])")
            .ends_with("nothing happens any more: `(lamp On)` does not follow `(running light)`."));
  CHECK(
      summary("(infinitelyoften (lamp On))").ends_with("`(lamp On)` does not become true again."));
  CHECK(summary("(precedes (lamp On) (ended mission))")
            .ends_with("`(ended mission)` becomes true without `(lamp On)` before it."));
  CHECK(summary("(ltl (<> (lamp On)))").find("nothing happens any more") != std::string::npos);
}

TEST_CASE("the dates of a step are those at which the run is a violation") {
  const auto trace = traceOf(R"((defsv lamp :states (On Off) :init On :transitions :all)
(defevent fails :effects (lamp Off))
(defskill look :action (look) :success seen)
(defproperty soon (present (lamp On) :before (lamp Off) :within [0,3]))
)",
                             "soon");
  REQUIRE(trace.steps.size() == 1);
  CHECK(trace.steps[0].earliest == ide::Moment{.seconds = {3}, .strict = true});
  CHECK(trace.summary.ends_with(
      "(present (lamp On) :before (lamp Off) :within [0,3]) does not hold."));
}

TEST_CASE("where an event may still come, nothing has to happen any more") {
  const auto trace = traceOf(R"((defsv lamp :states (On Off) :init Off :transitions :all)
(defevent dusk :effects (lamp On))
(defskill mission :success done :body ((^ 1) (success done)))
(defproperty lit (present (lamp On)))
)",
                             "lit");
  CHECK(
      trace.summary.ends_with("nothing has to happen any more: `(lamp On)` does not become true."));
}

TEST_CASE("an input is told with its value") {
  const auto moves =
      traceOf(kRobot + R"((defskill turn :input ($to lid) :success ok (:effects (lid $to)))
(defskill mission :body ((turn to Open) (turn to Shut)))
)",
              "lid.no_forbidden_transition");
  CHECK(stepThat(moves, "forbidden").why ==
        "`lid` is Open since step 4: no transition leads from there to Shut");
  const auto adds = traceOf(
      kRobot + R"((defskill fill :input ($by energy) :success ok (:effects (energy (+ energy $by))))
(defskill mission :body ((fill by 2)))
)",
      "energy.no_forbidden_transition");
  CHECK(stepThat(adds, "forbidden").why == "`energy` 3 + 2 = 5 is above `:max` 4");
}

TEST_CASE("a truth value is told with its input") {
  const auto chooses =
      traceOf(kRobot + R"((defskill turn :input ($gently bool) :success ok :failure no :body
  ((if $gently (success ok) else (failure no))))
(defskill mission :body ((turn gently true) (turn gently false)))
(defproperty works (never (ended turn failure)))
)",
              "works");
  CHECK(stepThat(chooses, "tests `$gently`: false").why == "`turn.gently` is false since step 7");
}

TEST_CASE("a step that repeats for ever alone is told as one") {
  const auto trace = traceOf("(defsv battery :states (Good Low) :init Good)\n"
                             "(defevent drain :every [1,2] :effects (battery Low))\n"
                             "(defskill mission :body ())\n"
                             "(defproperty charged (leadsto (battery Low) (battery Good)))",
                             "charged");
  REQUIRE(trace.loop);
  REQUIRE(trace.steps.size() == *trace.loop + 1);
  CHECK(trace.summary.starts_with("Step " + std::to_string(trace.steps.size()) +
                                  " can be repeated for ever"));
}
