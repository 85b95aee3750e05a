#include "runtime/executor/description.h"
#include "tests/runtime/run_of.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace proskill::test::monitor_test {

using runtime::RemarkKind;
using runtime::Verdict;

namespace {

constexpr std::string_view kProgram = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defsv parcels :min 0 :max 9 :init 0)
  (defevent storm :effects (sky Stormy))
  (defevent calm :effects (sky Clear))
  (defskill fly :time_interval [2,5] :action (fly) :interrupt () :success there :failure lost)
  (defskill mission :success done
    :body ((^ 1) (fly) (set ((parcels 1))) (^ 1) (label late) (^ 2) (success done)))
  (defproperty wish {}))";

/// The flight takes 3 s: it begins at 1 s and ends at 4 s; at 5 s comes the label, at 7 s the end.
test::Ran ranWith(const std::string& property, const std::string& signals = "") {
  return test::runOf(fmt::format(fmt::runtime(kProgram), property),
                     R"({"actions":{"fly":[{"result":"there","after":3}]},"signals":[)" + signals +
                         "]}");
}

/// Such as `false at 4`, in seconds.
std::string verdictOn(const std::string& property, const std::string& signals = "") {
  const auto ran = ranWith(property, signals);
  REQUIRE(ran.result.verdicts.size() == 1);
  const auto& [index, verdict, date] = ran.result.verdicts.front();
  auto text = std::string(toString(verdict));
  if (verdict != Verdict::NotYet) text += fmt::format(" at {}", static_cast<double>(date) / 1e9);
  CHECK((ran.told(RemarkKind::Violated) != nullptr) == (verdict == Verdict::False));
  CHECK((ran.told(RemarkKind::Holds) != nullptr) == (verdict == Verdict::True));
  CHECK(ran.result.bad == (verdict == Verdict::False ? 1 : 0));
  return text;
}

const std::string kStorm = R"({"at":2,"event":"storm"})";
const std::string kStormAndCalm = kStorm + R"(,{"at":2.5,"event":"calm"})";

/// What a run of the program prints.
std::vector<std::string> messagesOf(const std::string& text) {
  class Messages final : public runtime::Observer {
  public:
    explicit Messages(const runtime::Executable& of) : executable(of) {}
    void onStep(const runtime::Machine& machine, verify::TransitionId, runtime::Nanoseconds,
                runtime::Nanoseconds) override {
      if (const auto message = printedMessage(executable, machine)) all.push_back(*message);
    }
    void onRemark(const runtime::Remark&) override {}
    const runtime::Executable& executable;
    std::vector<std::string> all;
  };
  const auto executable = executableOf(text);
  Messages messages(*executable);
  const auto clock = runtime::simulatedClock();
  const auto platform = simulatedPlatform(defaultSettings(*executable), 1);
  std::ignore = execute(*executable, *clock, *platform, messages, {});
  return messages.all;
}

} // namespace

TEST_CASE("a condition on all states is false as soon as it is, and never true before the end") {
  CHECK(verdictOn("(always (sky Clear))") == "not yet");
  CHECK(verdictOn("(always (sky Clear))", kStorm) == "false at 2");
  CHECK(verdictOn("(always (sky Stormy))") == "false at 0");
  CHECK(verdictOn("(never (and (running fly) (sky Stormy)))", kStorm) == "false at 2");
  CHECK(verdictOn("(never (occurs storm))", kStorm) == "false at 2");
  CHECK(verdictOn("(never (at late))") == "false at 5");
  CHECK(verdictOn("(absent (ended fly failure))") == "not yet");
}

TEST_CASE("what can become true is true once it is, and never false") {
  CHECK(verdictOn("(reachable (running fly))") == "true at 1");
  CHECK(verdictOn("(reachable (sky Clear))") == "true at 0");
  CHECK(verdictOn("(reachable (= parcels 2))") == "not yet");
}

TEST_CASE("patterns are decided at the first moment at which nothing can change them") {
  CHECK(verdictOn("(present (running fly))") == "true at 1");
  CHECK(verdictOn("(present (= parcels 2))") == "not yet");
  CHECK(verdictOn("(present (= parcels 1) :within [0,4])") == "true at 4");
  CHECK(verdictOn("(present (= parcels 1) :within [0,4[)") == "false at 4");
  CHECK(verdictOn("(present (= parcels 1) :within [0,3.5])") == "false at 3.500000001");
  CHECK(verdictOn("(present (sky Stormy) :lasting 1)", kStorm) == "true at 3");
  CHECK(verdictOn("(present (sky Stormy) :lasting 1)", kStormAndCalm) == "false at 2.5");
  CHECK(verdictOn("(absent (running fly) :before (= parcels 1))") == "false at 4");
  CHECK(verdictOn("(absent (sky Stormy) :before (= parcels 1))") == "true at 4");
  CHECK(verdictOn("(absent (sky Stormy) :for [0,2])", kStorm) == "false at 2");
  CHECK(verdictOn("(absent (sky Stormy) :for [0,1.5])", kStorm) == "true at 1.500000001");
  CHECK(verdictOn("(absent (running fly) :after (= parcels 1) :for [0,1])") ==
        "true at 5.000000001");
  CHECK(verdictOn("(precedes (running fly) (= parcels 1))") == "true at 1");
  CHECK(verdictOn("(precedes (sky Stormy) (= parcels 1))") == "false at 4");
  CHECK(verdictOn("(infinitelyoften (running fly))") == "not yet");
}

TEST_CASE("a response that is late is reported when it is, not when something happens next") {
  CHECK(verdictOn("(leadsto (running fly) (= parcels 1) :within [0,3])") == "not yet");
  CHECK(verdictOn("(leadsto (running fly) (= parcels 1) :within [0,2.5])") ==
        "false at 3.500000001");
  CHECK(verdictOn("(leadsto (sky Stormy) (= parcels 1) :within [0,1])", kStorm) ==
        "false at 3.000000001");
  // each moment of the storm wants its own response: the first has one at 2 s, the last has none
  CHECK(verdictOn("(leadsto (sky Stormy) (sky Clear) :within [0,0.5])", kStormAndCalm) ==
        "not yet");
  CHECK(verdictOn("(leadsto (sky Stormy) (sky Clear) :within [0,0.4])", kStormAndCalm) ==
        "false at 2.400000001");
  CHECK(verdictOn("(leadsto (running fly) (= parcels 1))") == "not yet");
}

TEST_CASE("a formula is false if no continuation satisfies it, and true if all do") {
  CHECK(verdictOn("(ltl ([] (sky Clear)))", kStorm) == "false at 2");
  CHECK(verdictOn("(ltl (<> (running fly)))") == "true at 1");
  CHECK(verdictOn("(ltl (<> (= parcels 2)))") == "not yet");
  CHECK(verdictOn("(ltl ([] (<> (running fly))))") == "not yet");
  CHECK(verdictOn("(ltl (until (= parcels 0) (running fly)))") == "true at 1");
  CHECK(verdictOn("(ltl (until (not (running fly)) (= parcels 1)))") == "false at 1");
  CHECK(verdictOn("(ltl ([] (=> (occurs storm) (running fly))))", kStorm) == "not yet");
  CHECK(verdictOn("(ltl ([] (not (occurs storm))))", kStorm) == "false at 2");
  CHECK(verdictOn("(ltl (=> (sky Stormy) ([] (sky Clear))))") == "true at 0");
}

TEST_CASE("what a run cannot decide is reported as such") {
  CHECK(verdictOn("(deadlockfree)") == "not yet");
  const auto executable =
      test::executableOf(fmt::format(fmt::runtime(kProgram), "(deadlockfree)"), false);
  CHECK(whyNotMonitored(executable->properties.front()) ==
        "it is about what can happen, not about one run");
}

TEST_CASE("a property of an environment that is not executed is not monitored, and others are") {
  const std::string text = R"(
    (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
    (defskill mission :success done :body ((^ 1) (success done)))
    (defenvironment world :body ((label outside) (^ 1) (set (sky Stormy))))
    (defproperty inside (never (at outside)))
    (defproperty clear (never (ended mission success))))";
  const auto executable = executableOf(text, false);
  REQUIRE(executable->properties.size() == 2);
  CHECK(whyNotMonitored(executable->properties[0]) ==
        "it is about the environment, which is not executed");
  CHECK(runOf(*executable, 0).result.verdicts[0].verdict == Verdict::NotYet);
  CHECK(runOf(*executable, 0).result.verdicts[1].verdict == Verdict::False);
}

TEST_CASE("a message is printed with its values") {
  CHECK(messagesOf(R"(
    (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
    (defsv parcels :min 0 :max 9 :init 3)
    (defskill look :action (look) :success (seen missed))
    (defskill mission :success done :body
      ((look)
       (printf "%d of %d left, %s, %s: %f%% after %s" parcels (- parcels 1) sky look.status 2.5 "all")
       (success done))))") ==
        std::vector<std::string>{"3 of 2 left, Clear, success: 2.5% after all"});
}

TEST_CASE("a message has the values of inputs that the model contains") {
  CHECK(messagesOf(R"(
    (defsv parcels :min 0 :max 9 :init 3)
    (defskill load :input ($fast bool $count parcels $speed float) :body
      ((if (and $fast (< $count 5)) (printf "%s, %d, %d, %f" $fast $count (+ $count 1) $speed))))
    (defskill mission :body ((load fast true count 4 speed 1.5))))") ==
        std::vector<std::string>{"true, 4, 5, ?"});
}

TEST_CASE("a verdict names the property and its place, and comes at its date") {
  const auto ran = ranWith("(always (sky Clear))", kStorm);
  const auto* told = ran.told(RemarkKind::Violated);
  REQUIRE(told);
  CHECK(told->subject == "wish");
  CHECK(told->text == "(always (sky Clear))");
  CHECK(told->date == 2'000'000'000);
}

TEST_CASE("an interrupt is one step to a property, although its action is asked to stop first") {
  const std::string interrupt = R"({"at":2,"interrupt":"fly"})";
  CHECK(verdictOn("(always (or (running fly) (not (called fly)) (sky Clear)))", interrupt) ==
        "not yet");
  CHECK(verdictOn("(present (ended fly interrupted))", interrupt) == "true at 2");
}

} // namespace proskill::test::monitor_test
