#include "runtime/conform/conform.h"
#include "tests/runtime/run_of.h"
#include "tests/support/random/random_program.h"
#include "tests/support/random/seeds.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

using namespace proskill;
using runtime::Conformance;

namespace {

runtime::ConformResult judged(const std::string& text, const runtime::RecordedRun& run,
                              runtime::Nanoseconds tolerance = 0) {
  const auto result = conform(test::programOfText(text), run, {.tolerance = tolerance});
  if (!result) FAIL(result.error().message);
  return *result;
}

std::string textOf(const runtime::RecordedRun& run) {
  std::string text;
  for (const auto& [date, what, changes, stops, message] : run.steps) {
    text += fmt::format("{} {} {}", date, what.actor, what.description);
    for (const auto& change : changes)
      text += fmt::format(" [{} {} {}]", change.variable, change.before, change.after);
    text += message + "\n";
  }
  return text;
}

const std::string kProgram = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill fly
    :invariant (calm (:guard (sky Clear)))
    :time_interval [2,5] :action (fly) :interrupt () :success there :failure lost)
  (defskill mission :success done :body ((^ 1) (fly) (^ 1) (success done))))";

runtime::ConformResult judgedRun(const std::string& script, const std::string& platform = "",
                                 runtime::Nanoseconds tolerance = 0) {
  const auto executable = test::executableOf(kProgram, false);
  const auto ran = test::runOf(*executable, 0, script, platform);
  const auto result = judged(kProgram, ran.recorded, tolerance);
  UNSCOPED_INFO(textOf(ran.recorded) << result.step << " " << result.why << "\n"
                                     << result.assumption);
  return result;
}

std::string flight(const std::string& after) {
  return R"({"signals":[],"actions":{"fly":[{"result":"there","after":)" + after + "}]}}";
}

/// A platform whose action throws after 3 s.
class Throwing final : public runtime::Platform {
public:
  void start(const runtime::Start& start, runtime::Nanoseconds date) override {
    end = {.kind = runtime::ReportKind::Result,
           .date = date + 3 * runtime::kSecond,
           .action = start.action,
           .run = start.run,
           .text = "its action failed"};
  }
  bool stop(std::uint32_t, runtime::RunNumber, runtime::Nanoseconds) override { return true; }
  [[nodiscard]] std::optional<runtime::Nanoseconds> next() const override {
    return end ? std::optional(end->date) : std::nullopt;
  }
  bool poll(runtime::Nanoseconds date, runtime::Report& report) override {
    if (!end || end->date > date) return false;
    report = *std::exchange(end, std::nullopt);
    return true;
  }

private:
  std::optional<runtime::Report> end;
};

/// A platform with occasional interrupts of everything and frequent events, except those with
/// `:every`. \param stops the interval of the time that each action takes to stop
std::string interruptions(const runtime::Executable& executable,
                          const std::string& stops = "[0,0]") {
  std::string interrupts;
  std::string events;
  for (const auto& signal : executable.model.signals) {
    if (signal.every) continue;
    auto& to = signal.interrupts ? interrupts : events;
    to += fmt::format("{}\"{}\":[0.5,6]", to.empty() ? "" : ",", signal.name);
  }
  std::string actions;
  for (const auto& action : executable.model.performed)
    actions +=
        fmt::format("{}\"{}\":{{\"stops\":{}}}", actions.empty() ? "" : ",", action.skill, stops);
  return "{\"interrupts\":{" + interrupts + "},\"events\":{" + events + "},\"actions\":{" +
         actions + "}}";
}

} // namespace

TEST_CASE("a run that keeps its times conforms") {
  CHECK(judgedRun(flight("2")).verdict == Conformance::Conforms);
  CHECK(judgedRun(flight("5")).verdict == Conformance::Conforms);
  CHECK(judgedRun(R"({"signals":[{"at":2,"event":"storm"}]})").verdict == Conformance::Conforms);
  CHECK(judgedRun(R"({"signals":[{"at":2,"interrupt":"fly"}]})").verdict == Conformance::Conforms);
}

TEST_CASE("conform finds the assumption that a run breaks") {
  const auto early = judgedRun(flight("1.5"));
  CHECK(early.verdict == Conformance::Deviates);
  CHECK(early.assumption == "`fly` took 1.5 s; its interval promises at least 2 s");
  const auto late = judgedRun(flight("7"));
  CHECK(late.verdict == Conformance::Deviates);
  CHECK(late.why == "`fly` is still running");
  CHECK(late.assumption == "`fly` has run for 7 s; its interval promises at most 5 s");
  const auto slow = judgedRun(R"({"signals":[{"at":2,"interrupt":"fly"}]})",
                              R"({"actions":{"fly":{"stops":[0.5,0.5]}}})");
  CHECK(slow.verdict == Conformance::Deviates);
  CHECK(slow.assumption == "an action stops at once; that of `fly` took 0.5 s");
}

TEST_CASE("an action without a result breaks an assumption") {
  const auto executable = test::executableOf(kProgram, false);
  Throwing platform;
  const auto ran = test::runOf(*executable, platform, {.until = 60 * runtime::kSecond});
  INFO(ran.text());
  const auto result = judged(kProgram, ran.recorded);
  CHECK(result.verdict == Conformance::Deviates);
  CHECK(result.assumption == "an action ends with one of the results of its skill");
}

TEST_CASE("a recording of another version of the program is called one") {
  const auto run = test::runOf(*test::executableOf(kProgram, false), 0, flight("3")).recorded;
  const auto result = judged("; a comment" + kProgram, run);
  CHECK(result.verdict == Conformance::Deviates);
  CHECK(result.step == 0);
  CHECK(result.why == "in this program this step is at another place: the recording is of another "
                      "version of it");
  CHECK(result.isElsewhere);
}

TEST_CASE("places of steps can be ignored, but nothing else") {
  const auto printing = [](const std::string& before, const std::string& word) {
    return before + "(defsv sky :states (Clear Stormy) :init Clear)" + R"(
  (defskill fly :time_interval [2,5] :action (fly) :success there :failure lost)
  (defskill mission :success done :body
    ((fly) (printf ")" +
           word + R"( %s" sky) (success done))))";
  };
  const auto executable = test::executableOf(printing("", "sees"), false);
  const auto run = test::runOf(*executable, 0, flight("3")).recorded;
  const auto edited = [&](const std::string& program) {
    const auto result = conform(test::programOfText(program), run, {.placesMatter = false});
    return result ? result->why : result.error().message;
  };
  CHECK(edited(printing("", "sees")).empty());
  CHECK(edited(printing("; a comment\n", "sees")).empty());
  CHECK_FALSE(edited(printing("", "saw")).empty());
  auto other = run;
  REQUIRE(!other.steps.empty());
  for (auto& step : other.steps)
    if (!step.message.empty()) step.message += "!";
  const auto result =
      conform(test::programOfText(printing("", "sees")), other, {.placesMatter = false});
  REQUIRE(result);
  CHECK(result->why == "this step prints \"sees Clear\"");
}

TEST_CASE("an interval is broken, whatever an environment that was not executed has done") {
  const auto text = kProgram + R"(
  (defenvironment world :body
    ((while true (^ [1,...[) (choose ((emit storm)) ((fly.interrupt)))))))";
  const auto judgedIn = [&](const std::string& script) {
    const auto ran = test::runOf(*test::executableOf(text, false), 0, script, "");
    REQUIRE_FALSE(ran.recorded.head.environment);
    return judged(text, ran.recorded);
  };
  CHECK(judgedIn(flight("2")).verdict == Conformance::Conforms);
  const auto early = judgedIn(flight("1.5"));
  CHECK(early.verdict == Conformance::Deviates);
  CHECK(early.why == "it comes too early");
  const auto late = judgedIn(flight("7"));
  CHECK(late.verdict == Conformance::Deviates);
  CHECK(late.why == "`fly` is still running");
  const auto soon = judgedIn(R"({"signals":[{"at":0.2,"event":"storm"}]})");
  CHECK(soon.verdict == Conformance::Unknown);
}

TEST_CASE("a tolerance forgives what is that near") {
  CHECK(judgedRun(flight("1.995"), "", 10'000'000).verdict == Conformance::Conforms);
  CHECK(judgedRun(flight("5.005"), "", 10'000'000).verdict == Conformance::Conforms);
  const auto late = judgedRun(flight("5.015"), "", 10'000'000);
  CHECK(late.verdict == Conformance::Deviates);
  CHECK(late.assumption == "`fly` has run for 5.015 s; its interval promises at most 5 s");
  const auto stops = [](const std::string& time) {
    return judgedRun(R"({"signals":[{"at":2,"event":"storm"}]})",
                     R"({"actions":{"fly":{"stops":[)" + time + "," + time + "]}}}", 10'000'000)
        .verdict;
  };
  CHECK(stops("0.005") == Conformance::Conforms);
  CHECK(stops("0.015") == Conformance::Deviates);
}

TEST_CASE("a recording that somebody has changed does not conform, from that step on") {
  const auto executable = test::executableOf(kProgram, false);
  const auto run = test::runOf(*executable, 0, flight("3")).recorded;
  REQUIRE(judged(kProgram, run).verdict == Conformance::Conforms);
  for (std::size_t i = 0; i < run.steps.size(); ++i) {
    INFO("step " << i << "\n" << textOf(run));
    auto missing = run;
    missing.steps.erase(missing.steps.begin() + static_cast<std::ptrdiff_t>(i));
    if (i + 1 < run.steps.size()) CHECK(judged(kProgram, missing).verdict == Conformance::Deviates);
    auto twice = run;
    twice.steps.insert(twice.steps.begin() + static_cast<std::ptrdiff_t>(i), run.steps[i]);
    CHECK(judged(kProgram, twice).step == i + 1);
    auto other = run;
    other.steps[i].changes.push_back({"sky", "Clear", "Stormy"});
    CHECK(judged(kProgram, other).step == i);
    auto late = run;
    late.steps[i].date += 4'000'000'000;
    CHECK(judged(kProgram, late).verdict == Conformance::Deviates);
  }
}

TEST_CASE("a recording that claims what the program contradicts does not conform, from there on") {
  const std::string text = R"(
    (defsv parts :init 3 :min 0 :max 9)
    (defskill fly :input ($to real) :time_interval [2,5] :action (fly $to) :success there)
    (defskill mission :success done
      :body ((fly to 1.5) (printf "%d parts" parts) (success done))))";
  const auto executable = test::executableOf(text, false);
  const auto run = test::runOf(*executable, 0, flight("3")).recorded;
  REQUIRE(judged(text, run).verdict == Conformance::Conforms);
  const auto deviates = [&](auto&& change) {
    auto changed = run;
    change(changed);
    const auto result = judged(text, changed);
    CHECK(result.verdict == Conformance::Deviates);
    return std::pair(result.step, result.why);
  };
  CHECK(deviates([](auto& it) { it.head.initial[0].after = "4"; }) ==
        std::pair(std::size_t{0}, std::string("`parts` begins with `3`, not with `4`")));
  CHECK(deviates([](auto& it) { it.head.initial.pop_back(); }).first == 0);
  CHECK(deviates([](auto& it) { it.calls[0].arguments = {"9"}; }).first == run.calls[0].after);
  CHECK(deviates([](auto& it) { it.calls[0].date += 1; }).first == run.calls[0].after);
  const auto prints = std::ranges::find(run.steps, "3 parts", &runtime::RecordedStep::message);
  REQUIRE(prints != run.steps.end());
  const auto at = static_cast<std::size_t>(prints - run.steps.begin());
  CHECK(deviates([&](auto& it) { it.steps[at].message = "4 parts"; }) ==
        std::pair(at, std::string("this step prints \"3 parts\"")));
  CHECK(deviates([&](auto& it) { it.steps[0].message = "4 parts"; }).first == 0);
  for (std::size_t i = 0; i < run.steps.size(); ++i)
    CHECK(deviates([&](auto& it) { it.steps[i].what.begin = it.steps[i].what.end = 0; }).first ==
          i);
}

namespace {

/// Runs random programs on a platform whose actions take up to a time to stop.
void judgeRandomRuns(const std::string& stops, runtime::Nanoseconds tolerance) {
  std::size_t judgedRuns = 0;
  std::size_t steps = 0;
  const auto [first, end] = test::seedsOr(0, 400);
  for (std::uint64_t seed = first; seed < end; ++seed) {
    const auto text =
        test::textOf(test::randomProgram(seed, test::varied(seed, {.properties = 0})));
    const auto executable = test::executableOf(text);
    const auto ran = test::runOf(*executable, seed, "", interruptions(*executable, stops), 30);
    if (ran.steps.size() > 400) continue; // probably time has stopped
    const auto result = judged(text, ran.recorded, tolerance);
    INFO("seed " << seed << "\n" << text << textOf(ran.recorded));
    INFO("step " << result.step << ": " << result.why << "; " << result.assumption);
    CHECK(result.verdict == Conformance::Conforms);
    ++judgedRuns;
    steps += ran.steps.size();
  }
  CHECK(judgedRuns > (end - first) * 7 / 10);
  CHECK(steps > 5 * judgedRuns);
}

} // namespace

TEST_CASE("every simulated run of a random program conforms to the model that is verified") {
  judgeRandomRuns("[0,0]", 0);
}

TEST_CASE("with a tolerance, runs conform whose actions take time to stop") {
  judgeRandomRuns("[0,0.25]", runtime::kSecond / 4);
}

TEST_CASE("a tolerance forgives a slow stop, whatever happens meanwhile") {
  const std::string text = R"(
    (defsv sky :states (Clear Stormy) :init Clear)
    (defevent storm :effects (sky Stormy))
    (defevent clears :effects (sky Clear))
    (defskill fly
      :invariant (calm (:guard (sky Clear)))
      :time_interval [2,9] :action (fly) :success there)
    (defskill warn :time_interval [1,1] :action (warn) :success warned)
    (defskill watch :monitor t :body ((^ (sky Stormy)) (warn)))
    (defskill mission :success done :body ((fly) (success done))))";
  const auto ran =
      test::runOf(*test::executableOf(text, false), 0,
                  R"({"signals":[{"at":1,"event":"storm"},{"at":1.2,"event":"clears"}]})",
                  R"({"actions":{"fly":{"stops":[0.5,0.5]}}})");
  INFO(ran.text());
  CHECK(judged(text, ran.recorded, runtime::kSecond / 2).verdict == Conformance::Conforms);
  CHECK(judged(text, ran.recorded, runtime::kSecond / 4).assumption ==
        "an action stops at once; that of `fly` took 0.5 s");
  const auto exact = judged(text, ran.recorded);
  CHECK(exact.verdict == Conformance::Deviates);
  CHECK(exact.assumption == "an action stops at once; that of `fly` has not stopped after 0.2 s");
}

TEST_CASE("a run conforms only where events come as often as they say") {
  const std::string text = "(defsv n :init 0 :min 0 :max 9)"
                           "(defevent beat :every [2,3] :effects (n (+ n 1)))"
                           "(defskill mission :success done :body ((^ 5.5) (success done)))";
  const auto judgedBeats = [&](const std::string& second) {
    const auto script =
        R"({"signals":[{"at":2,"event":"beat"},{"at":)" + second + R"(,"event":"beat"}]})";
    const auto executable = test::executableOf(text, false);
    return judged(text, test::runOf(*executable, 0, script).recorded);
  };
  CHECK(judgedBeats("4").verdict == Conformance::Conforms);
  CHECK(judgedBeats("5").verdict == Conformance::Conforms);
  const auto early = judgedBeats("3.5");
  CHECK(early.verdict == Conformance::Deviates);
  CHECK(early.assumption == "`beat` came after 1.5 s; its `:every` promises at least 2 s");
  const auto late = judgedBeats("5.25");
  CHECK(late.verdict == Conformance::Deviates);
  CHECK(late.why == "`beat` has not come");
}
