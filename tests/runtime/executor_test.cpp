#include "runtime/platform/settings.h"
#include "tests/runtime/run_of.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

using namespace proskill;
using runtime::End;
using runtime::RemarkKind;
using test::runOf;

namespace {

/// A skill that takes time, may be interrupted, and has a guard.
const std::string kFly = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defsv motors :states (Off On) :init Off :transitions ((Off On) (On Off)))
  (defevent storm :effects (sky Stormy))
  (defskill fly
    :start (motors On)
    :invariant (calm (:guard (sky Clear) :effects (motors Off)))
    :time_interval [2,5]
    :action (fly)
    :interrupt (:effects (motors Off))
    :success there (:effects (motors Off) :postcondition (sky Clear))
    :failure lost)
)";

std::string mission(const std::string& body, const std::string& fields = "") {
  return kFly + "(defskill mission " + fields + " :success done :failure failed :body (" + body +
         "))";
}

} // namespace

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

namespace {

/// Performs nothing, and calls what a test sets.
class Silent final : public runtime::Platform {
public:
  void start(const runtime::Start&, runtime::Nanoseconds) override { onStart(); }
  bool stop(std::uint32_t, runtime::RunNumber, runtime::Nanoseconds) override {
    onStop();
    return false;
  }
  [[nodiscard]] std::optional<runtime::Nanoseconds> next() const override { return {}; }
  bool poll(runtime::Nanoseconds date, runtime::Report& report) override {
    return onPoll(date, report);
  }
  [[nodiscard]] bool mayReport() const override { return true; }

  std::function<bool(runtime::Nanoseconds, runtime::Report&)> onPoll = [](auto, auto&) {
    return false;
  };
  std::function<void()> onStart = [] {};
  std::function<void()> onStop = [] {};
};

/// A clock that a test sets.
class Jumping final : public runtime::Clock {
public:
  explicit Jumping(std::vector<runtime::Nanoseconds> all) : dates(std::move(all)) {}
  void start() override {}
  runtime::Nanoseconds now() override { return dates[at]; }
  void wait(std::optional<runtime::Nanoseconds>, const std::vector<int>&) override {
    at = std::min(at + 1, dates.size() - 1);
    onWait();
  }
  [[nodiscard]] bool isReal() const override { return true; }

  std::function<void()> onWait = [] {};

private:
  std::vector<runtime::Nanoseconds> dates;
  std::size_t at = 0;
};

} // namespace

TEST_CASE("a request to end before the start takes no step") {
  const auto executable = test::executableOf(mission("(fly) (success done)"), false);
  const std::atomic<int> requests = 1;
  Silent silent;
  const auto before = runOf(*executable, silent, {.stopRequests = &requests});
  CHECK(before.result.end == End::Stopped);
  CHECK(before.result.steps == 0);
}

TEST_CASE("a request to end stops what runs; a second one does not wait for it") {
  const auto executable = test::executableOf(mission("(fly) (success done)"), false);
  const auto endedBy = [&](int more) {
    std::atomic<int> requests = 0;
    Silent silent;
    silent.onStart = [&] { ++requests; };
    silent.onStop = [&] { requests += more; };
    return runOf(*executable, silent, {.grace = runtime::kSecond, .stopRequests = &requests});
  };
  const auto once = endedBy(0);
  CHECK(once.result.end == End::Abandoned);
  CHECK(once.result.date == runtime::kSecond);
  REQUIRE(once.told(RemarkKind::Asked));
  REQUIRE(once.told(RemarkKind::Fault));
  CHECK(once.told(RemarkKind::Fault)->text ==
        "its action did not stop in time, and may still be running");
  const auto twice = endedBy(1);
  CHECK(twice.result.end == End::Abandoned);
  CHECK(twice.result.date == 0);
  CHECK(twice.told(RemarkKind::Fault));
}

TEST_CASE("a request to end long after the last step leaves actions their time to stop") {
  const auto executable = test::executableOf(mission("(fly) (success done)"), false);
  std::atomic<int> requests = 0;
  Silent slow;
  bool hasStopped = false;
  slow.onPoll = [&](runtime::Nanoseconds date, runtime::Report& report) {
    report = {.run = 1};
    return date == 10 * runtime::kSecond && !std::exchange(hasStopped, true);
  };
  Jumping clock({0, 9 * runtime::kSecond, 10 * runtime::kSecond, 20 * runtime::kSecond});
  clock.onWait = [&] { requests = 1; };
  const auto ran = runOf(*executable, slow, clock, {.stopRequests = &requests});
  CHECK(ran.result.end == End::Stopped);
  CHECK_FALSE(ran.told(RemarkKind::Fault));
  REQUIRE(ran.told(RemarkKind::Asked));
  CHECK(ran.told(RemarkKind::Asked)->date == 9 * runtime::kSecond);
  CHECK(ran.told(RemarkKind::Note)->date == 9 * runtime::kSecond);
}

TEST_CASE("after a clock has jumped, steps keep their own dates, and it is said") {
  const auto executable = test::executableOf(mission("(^ 1) (^ 2) (^ 0.5) (success done)"), false);
  Silent silent;
  Jumping clock({0, 3600 * runtime::kSecond});
  const auto ran = runOf(*executable, silent, clock, {});
  INFO(ran.text());
  CHECK(ran.result.end == End::Mission);
  CHECK(ran.when("mission", "succeeds with `done`") == 3.5);
  CHECK(ran.maxLag == 3599 * runtime::kSecond);
  REQUIRE(ran.told(RemarkKind::Note));
  CHECK(ran.told(RemarkKind::Note)->text ==
        "this process was suspended: steps are taken later than their dates, and what the platform "
        "has reported is dated later");
  CHECK(std::ranges::count(ran.remarks, RemarkKind::Note, &test::Ran::Told::kind) == 1);
}

TEST_CASE("a result that is read late, since a clock has jumped, comes with a note") {
  const auto executable = test::executableOf(mission("(fly) (success done)"), false);
  Silent late;
  bool isOver = false;
  late.onPoll = [&](runtime::Nanoseconds date, runtime::Report& report) {
    report = {.kind = runtime::ReportKind::Result, .date = date, .run = 1, .result = 0};
    return date > runtime::kSecond && !std::exchange(isOver, true);
  };
  Jumping clock({0, runtime::kSecond, 3600 * runtime::kSecond});
  const auto ran = runOf(*executable, late, clock, {});
  INFO(ran.text());
  CHECK(ran.result.end == End::Mission);
  CHECK(std::ranges::count(ran.remarks, RemarkKind::Note, &test::Ran::Told::kind) == 1);
}

TEST_CASE("what is judged late is reported with its own date, and in the order of dates") {
  const auto executable = test::executableOf(
      "(defskill fly :time_interval [2,5] :action (fly) :success there)"
      "(defskill look :time_interval [1,4] :action (look) :success seen)"
      "(defskill mission :success done :body ((// ((fly)) ((look))) (success done)))"
      "(defproperty early (leadsto (running fly) (= fly.status success) :within [0,4.5]))"
      "(defproperty late (leadsto (running fly) (= fly.status success) :within [0,6]))",
      false);
  Silent silent;
  Jumping clock({0, 60 * runtime::kSecond});
  const auto ran = runOf(*executable, silent, clock, {.until = 60 * runtime::kSecond});
  std::string said;
  for (const auto& [kind, date, subject, text] : ran.remarks)
    if (kind == RemarkKind::Overshoot || kind == RemarkKind::Violated)
      said += fmt::format("{} {}\n", subject, date);
  CHECK(said == "look 4000000001\nearly 4500000001\nfly 5000000001\nlate 6000000001\n");
}

TEST_CASE("a clock that goes back does not take time back") {
  const auto executable = test::executableOf(mission("(^ 2) (^ 2) (success done)"), false);
  Silent silent;
  Jumping clock({0, 3 * runtime::kSecond, runtime::kSecond, 4 * runtime::kSecond});
  const auto ran = runOf(*executable, silent, clock, {});
  CHECK(ran.when("mission", "succeeds with `done`") == 4);
  for (std::size_t i = 1; i < ran.steps.size(); ++i)
    CHECK(ran.steps[i - 1].date <= ran.steps[i].date);
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
