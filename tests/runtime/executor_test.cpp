#include "runtime/platform/settings.h"
#include "tests/runtime/flying.h"
#include "tests/runtime/run_of.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;
using runtime::End;
using runtime::RemarkKind;
using test::kFly;
using test::mission;
using test::runOf;

TEST_CASE("a mission calls an action, waits for its result, and ends") {
  const auto ran = runOf(mission("(fly) (^ 1.5) (success done)"),
                         R"({"signals":[],"actions":{"fly":[{"result":"there","after":3.25}]}})");
  INFO(ran.text());
  CHECK(ran.result.end == End::Mission);
  CHECK(ran.result.missionStatus == "success");
  CHECK(ran.when("fly", "starts") == 0);
  CHECK(ran.when("fly", "succeeds with `there`") == 3.25);
  CHECK(ran.when("mission", "succeeds with `done`") == 4.75);
  CHECK(ran.result.bad == 0);
}

TEST_CASE("bounds of time are met to the nanosecond") {
  const auto at = [](const std::string& interval, const std::string& after) {
    auto text = mission("(fly) (success done)");
    text.replace(text.find("[2,5]"), 5, interval);
    const auto ran = runOf(text, R"({"signals":[],"actions":{"fly":[{"result":"there","after":)" +
                                     after + "}]}}");
    if (ran.told(RemarkKind::Undershoot)) return std::string("undershoot");
    const auto* late = ran.told(RemarkKind::Overshoot);
    return late ? "overshoot at " + std::to_string(late->date) : std::string("on time");
  };
  CHECK(at("[2,5]", "2") == "on time");
  CHECK(at("[2,5]", "1.999999999") == "undershoot");
  CHECK(at("[2,5]", "5") == "on time");
  CHECK(at("[2,5]", "5.000000001") == "overshoot at 5000000001");
  CHECK(at("]2,5[", "2") == "undershoot");
  CHECK(at("]2,5[", "2.000000001") == "on time");
  CHECK(at("]2,5[", "4.999999999") == "on time");
  CHECK(at("]2,5[", "5") == "overshoot at 5000000000");
  CHECK(at("]2,5[", "100") == "overshoot at 5000000000");
}

TEST_CASE("an action that hangs or is late overshoots, and the program decides what follows") {
  const std::string hangs =
      R"({"signals":[],"actions":{"fly":[{"result":"there","after":1000000}]}})";
  const auto waiting = runOf(mission("(fly) (success done)"), hangs);
  CHECK(waiting.result.end == End::Until);
  CHECK(waiting.result.bad == 1);
  REQUIRE(waiting.told(RemarkKind::Overshoot));
  CHECK(waiting.told(RemarkKind::Overshoot)->date == 5'000'000'001);
  const auto giving = runOf(mission("(// ((fly)) ((^ 8) (fly.interrupt))) (success done)"), hangs);
  INFO(giving.text());
  CHECK(giving.told(RemarkKind::Overshoot));
  CHECK(giving.when("fly", "asks its action to stop") == 8);
  CHECK(giving.result.missionStatus == "success");
}

TEST_CASE("a wait ends at the first moment of its interval") {
  CHECK(runOf(mission("(^ [1,3]) (success done)")).result.date == 1'000'000'000);
  CHECK(runOf(mission("(^ ]1,3]) (success done)")).result.date == 1'001'000'000);
  CHECK(runOf(mission("(^ ]1,...[) (success done)")).result.date == 1'001'000'000);
  CHECK(runOf(mission("(^ ]1,1.001[) (success done)")).result.date == 1'000'500'000);
}

TEST_CASE("a composite skill that takes too little or too much is told of, when it does") {
  const auto early = runOf(mission("(^ 1) (success done)", ":time_interval [2,4]"));
  REQUIRE(early.told(RemarkKind::Undershoot));
  CHECK(early.told(RemarkKind::Undershoot)->subject == "mission");
  CHECK(early.result.bad == 1);
  const auto late = runOf(mission("(^ 5) (success done)", ":time_interval [2,4]"));
  REQUIRE(late.told(RemarkKind::Overshoot));
  CHECK(late.told(RemarkKind::Overshoot)->date == 4'000'000'001);
  CHECK(runOf(mission("(^ 4) (success done)", ":time_interval [2,4]")).result.bad == 0);
}

TEST_CASE("an interrupt from outside stops the action, and its effects are set") {
  const auto ran =
      runOf(mission("(fly) (success done)"),
            R"({"signals":[{"at":1,"interrupt":"fly"},{"at":1.5,"interrupt":"fly"}]})");
  INFO(ran.text());
  CHECK(ran.when("fly", "asks its action to stop") == 1);
  CHECK(ran.when("fly", "is interrupted from outside") == 1);
  CHECK(ran.result.date == 1'000'000'000);
}

TEST_CASE("the failed guard of a composite skill is told once, when it is noticed") {
  const auto ran = runOf(mission("(fly)", ":invariant (dry (:guard (sky Clear)))"),
                         R"({"signals":[{"at":1,"event":"storm"}]})");
  INFO(ran.text());
  CHECK(ran.when("mission", "finds its invariant `dry` violated") == 1);
  CHECK(ran.when("mission", "ends because of its invariant `dry`") == 1);
  CHECK(std::ranges::count_if(ran.remarks, [](const auto& remark) {
          return remark.kind == RemarkKind::GuardFailed && remark.subject == "mission";
        }) == 1);
}

TEST_CASE("a skill whose action is slow to stop keeps what it has until it has stopped") {
  const auto executable = test::executableOf(mission("(fly) (success done)"), false);
  const auto ran = runOf(*executable, 0, R"({"signals":[{"at":1,"event":"storm"}]})",
                         R"({"actions":{"fly":{"stops":[0.5,0.5]}}})");
  INFO(ran.text());
  CHECK(ran.when("fly", "asks its action to stop") == 1);
  CHECK(ran.when("fly", "finds its invariant `calm` violated") == 1.5);
  REQUIRE(ran.told(RemarkKind::GuardFailed));
  CHECK(ran.result.bad == 0);
}

TEST_CASE("a forbidden move and a failed postcondition are told of, where they are made") {
  auto text = mission("(fly) (success done)");
  text.replace(text.find("((Off On) (On Off))"), 19, "((Off On))");
  const auto ran = runOf(text, R"({"signals":[],"actions":{"fly":[{"result":"there"}]}})");
  REQUIRE(ran.told(RemarkKind::Alarm));
  CHECK(ran.told(RemarkKind::Alarm)->text == "makes a forbidden move: `(motors Off)`");
  const auto stormy = runOf(mission("(^ 9) (fly) (success done)"),
                            R"({"signals":[],"actions":{"fly":[{"result":"lost"}]}})");
  CHECK(stormy.told(RemarkKind::Alarm) == nullptr);
}

TEST_CASE("a monitor's action ends before the run does") {
  const auto ran = runOf(kFly + R"((defskill mission :body ((^ 1)))
                                   (defskill watch :monitor t :body ((^ 0.5) (fly))))");
  INFO(ran.text());
  CHECK(ran.result.end == End::Mission);
  CHECK(ran.result.date >= 2'500'000'000);
}

TEST_CASE("a run ends where nothing can happen, where its time is over, where time stands still") {
  CHECK(runOf(mission("(^ (sky Stormy)) (success done)")).result.end == End::Stuck);
  const auto endless = runOf(mission("(while true (^ 1)) (success done)"));
  CHECK(endless.result.end == End::Until);
  CHECK(endless.result.date == 600'000'000'000);
  CHECK(runOf(mission("(while true (if (sky Stormy) (^ 1))) (success done)")).result.end ==
        End::NoTime);
}

TEST_CASE("a wait that needs no time lets time pass when it begins again") {
  const auto program = test::executableOf(mission("(while true (^ [0,0.001])) (success done)"));
  const auto ran = runOf(*program, 0, {}, {}, 0.1);
  CHECK(ran.result.end == End::Until);
  CHECK(ran.result.steps < 1000);
  CHECK(runOf(mission("(^ [0,...[) (^ [0,5]) (success done)")).result.date == 0);
  const auto retries = mission("(label again) (^ [0,...[) (if (sky Clear) (goto again))"
                               " (success done)");
  const auto date = runOf(retries, R"({"signals":[{"at":2,"event":"storm"}]})").result.date;
  CHECK((date == 2'000'000'000 || date == 2'001'000'000)); // before or after the wait of this date
}

TEST_CASE("an event comes as often as it says, or is told of") {
  const auto run = [](const std::string& every, const std::string& script) {
    return runOf("(defsv n :init 0 :min 0 :max 9) (defevent beat :every " + every +
                     " :effects (n (+ n 1))) (defskill mission :success done"
                     " :body ((^ (= n 3)) (success done)))",
                 script);
  };
  const auto ran = run("[2,3]", "");
  INFO(ran.text());
  CHECK(ran.result.missionStatus == "success");
  CHECK(ran.result.bad == 0);
  CHECK(ran.result.date >= 6'000'000'000);
  CHECK(ran.result.date <= 9'000'000'000);
  const auto script = [](const std::string& third) {
    return R"({"signals":[{"at":2,"event":"beat"},{"at":5,"event":"beat"},{"at":)" + third +
           R"(,"event":"beat"}]})";
  };
  CHECK(run("[2,3]", script("7")).result.bad == 0);
  const auto early = run("[2,3]", script("6.5"));
  REQUIRE(early.told(RemarkKind::Undershoot));
  CHECK(early.told(RemarkKind::Undershoot)->subject == "beat");
  const auto late = run("[2,3]", script("8.5"));
  REQUIRE(late.told(RemarkKind::Overshoot));
  CHECK(late.told(RemarkKind::Overshoot)->date == 8'000'000'001);
}

TEST_CASE("an event whose guard does not hold is ignored") {
  const auto ran =
      runOf("(defsv door :states (Closed Open) :init Closed) (defevent opens :effects (door Open))"
            "(defevent slams :guard (door Open) :effects (door Closed))"
            "(defskill mission :success done :body ((^ (door Open)) (^ (door Closed)) (success "
            "done)))",
            R"({"signals":[{"at":1,"event":"slams"},{"at":2,"event":"opens"},)"
            R"({"at":3,"event":"slams"}]})");
  CHECK(ran.result.missionStatus == "success");
  CHECK(ran.result.date == 3'000'000'000);
  REQUIRE(ran.told(RemarkKind::Note));
  CHECK(ran.told(RemarkKind::Note)->text == "ignored: the `:guard` of this event does not hold");
}

TEST_CASE("a run draws the initial values by its seed") {
  const auto executable =
      test::executableOf("(defsv door :states (Closed Open) :init (Closed Open))"
                         "(defskill mission :success (was_open was_closed)"
                         " :body ((if (door Open) (success was_open)) (success was_closed)))");
  std::size_t open = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto ran = runOf(*executable, seed);
    CHECK(ran.result.missionStatus == "success");
    CHECK(ran.when("mission", "starts") == 0);
    if (ran.text().contains("was_open")) ++open;
  }
  CHECK(open > 5);
  CHECK(open < 35);
}

TEST_CASE("with ticks, what is due or reported is handled at the next tick, and dates stay exact") {
  const auto executable = test::executableOf(mission("(^ 1.25) (fly) (success done)"), false);
  auto settings = defaultSettings(*executable);
  const auto script = runtime::JsonFile::parse(
      R"({"signals":[],"actions":{"fly":[{"result":"there","after":2.3}]}})");
  REQUIRE(readScript(script.value(), executable->model, settings).empty());
  const auto platform = simulatedPlatform(std::move(settings), 1);
  const auto clock = tickingClock(runtime::simulatedClock(), runtime::kSecond / 2);
  const auto ran = test::runOf(*executable, *platform, *clock, {});
  INFO(ran.text());
  CHECK(ran.when("mission", "has waited 1.25 s") == 1.25);
  CHECK(ran.maxLag == 250'000'000);
  CHECK(ran.when("fly", "succeeds with `there`") == 4); // 2.3 s after its start at 1.25 s or 1.5 s
  CHECK(ran.result.date == 4'000'000'000);
}

TEST_CASE("a script about an action that the program does not have is refused") {
  const auto executable = test::executableOf(mission("(fly) (success done)"), false);
  auto settings = defaultSettings(*executable);
  for (const auto* runs : {"[]", R"([{"after":1}])"}) {
    const auto script =
        runtime::JsonFile::parse(std::string(R"({"actions":{"flie":)") + runs + "}}");
    CHECK(readScript(script.value(), executable->model, settings).at(0).text() ==
          "1:13: there is no basic skill `flie`");
  }
}
