#include "runtime/platform/messages.h"
#include "runtime/platform/process.h"
#include "tests/runtime/run_of.h"
#include "tests/support/run.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <thread>

using namespace proskill;
using runtime::End;
using runtime::RemarkKind;

namespace {

/// A platform's program in shell: `hear` reads a line, `say` sends one, `leave` waits for the end
/// of the run.
const std::string kSpoken = R"(
hear() { read -r heard || exit 0; }
say() { printf '%s\n' "$1"; }
leave() { cat > /dev/null; exit 0; }
ready() { hear; say '{"type":"ready","protocol":1}'; }
)";

const std::string kSpokenProgram = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill fly :action (fly 3 "a \"b\"" true -0.5) :interrupt () :success there :failure lost)
)";

struct Talk {
  std::string body = "(fly) (if (= fly.status success) (success done) else (failure failed))";
  runtime::Nanoseconds grace = 20 * runtime::kSecond;
  unsigned restarts = 0;
  std::atomic<int>* stopRequests = nullptr;
};

test::Ran talk(const std::string& script, const Talk& with = {}) {
  const auto executable = test::executableOf(
      kSpokenProgram + "(defskill mission :success done :failure failed :body (" + with.body + "))",
      false);
  auto platform = runtime::processPlatform(*executable,
                                           {.command = {"/bin/sh", "-c", kSpoken + script},
                                            .directory = "/",
                                            .restarts = with.restarts,
                                            .restartDelay = 1},
                                           [] { return false; });
  if (!platform) FAIL(platform.error().why);
  return test::runInRealTime(
      *executable, **platform,
      {.until = 30 * runtime::kSecond, .grace = with.grace, .stopRequests = with.stopRequests});
}

std::string whyNotStarted(const std::vector<std::string>& command,
                          runtime::Nanoseconds startup = 20 * runtime::kSecond) {
  const auto executable = test::executableOf(kSpokenProgram, false);
  const auto platform = runtime::processPlatform(
      *executable, {.command = command, .directory = "/", .startup = startup},
      [] { return false; });
  return platform ? "" : platform.error().why;
}

/// The text of the first fault, after its subject.
std::string faultOf(const test::Ran& ran) {
  const auto* fault = ran.told(RemarkKind::Fault);
  return fault ? (fault->subject.empty() ? "" : fault->subject + ": ") + fault->text : "";
}

const std::string kThere = R"(say '{"type":"result","run":1,"result":"there"}'; )";

} // namespace

TEST_CASE("a program on a pipe performs the actions") {
  const auto ran = talk("ready; hear; " + kThere + "leave");
  INFO(ran.text());
  CHECK(ran.result.end == End::Mission);
  CHECK(ran.result.missionStatus == "success");
  CHECK(ran.result.bad == 0);
  CHECK(ran.when("fly", "succeeds with `there`") >= 0);
}

TEST_CASE("a program is told what there is, what starts with which arguments, and the end") {
  const test::TemporaryDirectory files;
  const auto heard = files.path("heard");
  const auto ran = talk("read -r hello; printf '%s\\n' \"$hello\" > " + heard +
                        "; say '{\"type\":\"ready\",\"protocol\":1}'; hear; printf '%s\\n' "
                        "\"$heard\" >> " +
                        heard + "; " + kThere + "cat >> " + heard);
  CHECK(ran.result.bad == 0);
  std::ifstream lines(heard);
  std::string hello;
  std::string start;
  std::string end;
  std::getline(lines, hello);
  std::getline(lines, start);
  std::getline(lines, end);
  CHECK(hello ==
        R"({"type":"hello","protocol":1,"mission":"mission","speed":1.0,"skills":)"
        R"([{"name":"fly","results":[{"name":"there","status":"success"},)"
        R"({"name":"lost","status":"failure"}]}],"events":["storm"],"interrupts":["fly"]})");
  const std::string rest = R"(,"arguments":[3,"a \"b\"",true,-0.5],"command":"fly"})";
  CHECK(start.starts_with(R"({"type":"start","run":1,"skill":"fly","time":)"));
  CHECK(start.ends_with(rest));
  CHECK(end == R"({"type":"end"})");
}

TEST_CASE("a program reports events and interrupts") {
  const auto storm = talk(R"(ready; say '{"type":"event","name":"storm"}'; leave)",
                          {.body = "(^ (sky Stormy)) (success done)"});
  CHECK(storm.result.missionStatus == "success");
  const auto ran = talk(R"(ready; hear; say '{"type":"interrupt","skill":"fly"}'; hear;
                           say '{"type":"stopped","run":1}'; leave)");
  INFO(ran.text());
  CHECK(ran.when("fly", "asks its action to stop") >= 0);
  CHECK(ran.when("fly", "is interrupted from outside") >= 0);
  CHECK(ran.result.missionStatus == "failure");
  CHECK(ran.result.bad == 0);
}

TEST_CASE("what a program logs stands in the recording") {
  const auto ran =
      talk(R"(ready; hear; say '{"type":"log","text":"wind: 3 m/s"}'; )" + kThere + "leave");
  REQUIRE(ran.told(RemarkKind::Note));
  CHECK(ran.told(RemarkKind::Note)->text == "wind: 3 m/s");
  CHECK(ran.result.bad == 0);
}

TEST_CASE("a program that cannot be used is said before the run begins") {
  const auto shell = [](const std::string& script) {
    return std::vector<std::string>{"/bin/sh", "-c", kSpoken + script};
  };
  CHECK(whyNotStarted({"/no/such/program"}) ==
        "`/no/such/program` cannot be started: No such file or directory");
  CHECK(whyNotStarted(shell("exit 3")) ==
        "the connection to the platform's program is lost: it ended with exit code 3");
  CHECK(whyNotStarted(shell(R"(hear; say '{"type":"ready","protocol":2}'; leave)")) ==
        "the platform's program speaks version 2 of the protocol, not 1");
  CHECK(whyNotStarted(shell(R"(hear; say '{"type":"failed","text":"no robot"}'; leave)")) ==
        "the platform's program gives up: no robot");
  CHECK(whyNotStarted(shell("leave"), 1'000'000) ==
        "the platform's program is not ready after 0.001 s");
}

TEST_CASE("an action that throws ends its skill without a result, and the rest goes on") {
  const auto ran =
      talk(R"(ready; hear; say '{"type":"failed","run":1,"text":"ValueError: no wings"}'; leave)");
  CHECK(faultOf(ran) == "fly: its action failed: ValueError: no wings");
  CHECK(ran.told(RemarkKind::Alarm));
  CHECK(ran.result.end == End::Mission);
  CHECK(ran.result.missionStatus == "failure");
}

TEST_CASE("a result that the skill does not have ends it without a result") {
  const auto ran = talk(R"(ready; hear; say '{"type":"result","run":1,"result":"thre"}'; leave)");
  CHECK(faultOf(ran) == "fly: its action has no result `thre`");
  CHECK(ran.told(RemarkKind::Alarm));
  CHECK(ran.result.missionStatus == "failure");
}

TEST_CASE("an action that stops without being asked has no result") {
  const auto ran = talk(R"(ready; hear; say '{"type":"stopped","run":1}'; leave)");
  CHECK(faultOf(ran) == "fly: its action has stopped without being asked to");
  CHECK(ran.result.missionStatus == "failure");
}

TEST_CASE("a second result is ignored, and is not taken for one of the next start") {
  const auto ran = talk("ready; hear; " + kThere + kThere + R"(
                         hear; say '{"type":"result","run":1,"result":"there"}'
                         say '{"type":"result","run":7,"result":"there"}'
                         say '{"type":"result","run":2,"result":"lost"}'; leave)",
                        {.body = "(fly) (fly) (if (= fly.status success) (success done) else "
                                 "(failure failed))"});
  INFO(ran.text());
  CHECK(ran.result.missionStatus == "failure");
  CHECK(ran.result.bad == 3);
  CHECK(faultOf(ran).ends_with("it is ignored"));
}

TEST_CASE("a result after the interrupt is the stop") {
  const auto ran =
      talk(R"(ready; hear; say '{"type":"interrupt","skill":"fly"}'; hear; )" + kThere + "leave");
  CHECK(ran.when("fly", "is interrupted from outside") >= 0);
  CHECK(ran.when("fly", "succeeds with `there`") == -1);
  CHECK(ran.result.bad == 0);
}

TEST_CASE("an action that never stops is given up, and its skill ends without it") {
  const auto ran =
      talk(R"(ready; hear; say '{"type":"interrupt","skill":"fly"}'; hear; hear; leave)",
           {.grace = runtime::kSecond / 20});
  CHECK(faultOf(ran) == "fly: its action does not stop; its skill ends without it");
  CHECK(ran.when("fly", "is interrupted from outside") >= 0);
}

TEST_CASE("garbage on the line is ignored, and said") {
  const auto fault = [](const std::string& line) {
    const auto ran = talk("ready; hear; " + line + "; " + kThere + "leave");
    CHECK(ran.result.missionStatus == "success");
    CHECK(ran.result.bad == 1);
    return faultOf(ran);
  };
  const std::string ignored = "the platform sent a line that is ignored: ";
  CHECK(fault("say 'starting up…'") == ignored + "it is not JSON: `starting up…`");
  CHECK(fault(R"(printf '\377\000\033[1m\n')").starts_with(ignored + "it is not JSON: "));
  CHECK(fault("say '[1]'") == ignored + "it is not a JSON object: `[1]`");
  CHECK(fault("say '{\"typ\":1}'") == ignored + "`type` must be a string: `{\"typ\":1}`");
  CHECK(fault(R"(say '{"type":"dance"}')") ==
        ignored + R"(there is no message `dance`: `{"type":"dance"}`)");
  CHECK(fault(R"(say '{"type":"result","run":-1}')").starts_with(ignored + "`run` must be"));
  CHECK(fault(R"(say '{"type":"event","name":"strom"}')") ==
        "the platform reports an event `strom`, which is not known");
  CHECK(fault(R"(say '{"type":"interrupt","skill":"mission"}')") ==
        "the platform reports an interrupt of `mission`, which is not known");
  CHECK(fault(R"(say '{"type":"ready","protocol":1}')") == "the platform sent `ready` twice");
}

TEST_CASE("a line that is too long is dropped as a whole") {
  const auto ran =
      talk("ready; hear; head -c 3000000 /dev/zero | tr '\\0' x; say ''; " + kThere + "leave");
  CHECK(ran.result.missionStatus == "success");
  CHECK(ran.result.bad == 1);
  CHECK(faultOf(ran) == "the platform sent a line of more than 1048576 bytes; it is ignored");
}

TEST_CASE("a program that ends ends its actions, and the run with the next start") {
  const auto ran = talk("ready; hear; exit 7", {.body = "(fly) (fly)"});
  INFO(ran.text());
  CHECK(faultOf(ran) ==
        "the connection to the platform's program is lost: it ended with exit code 7");
  CHECK(ran.told(RemarkKind::Alarm));
  CHECK(ran.result.end == End::Lost);
  const auto killed = talk("ready; hear; kill -KILL $$", {.body = "(fly)"});
  CHECK(faultOf(killed).find("signal 9") != std::string::npos);
  CHECK(killed.result.end == End::Mission);
}

TEST_CASE("what a program has said before it ended counts") {
  const auto ran = talk("ready; hear; " + kThere + "exit 0");
  CHECK(ran.result.missionStatus == "success");
}

TEST_CASE("a lost program is started again, and goes on") {
  const test::TemporaryDirectory files;
  const auto second = files.path("second");
  const auto ran =
      talk("ready; hear; [ -e " + second + " ] || { touch " + second + "; exit 1; }; " +
               R"(say '{"type":"result","run":2,"result":"there"}'; leave)",
           {.body = "(fly) (fly) (if (= fly.status success) (success done))", .restarts = 1});
  INFO(ran.text());
  CHECK(ran.result.end == End::Mission);
  CHECK(ran.result.missionStatus == "success");
  CHECK(faultOf(ran) ==
        "the connection to the platform's program is lost: it ended with exit code 1");
}

TEST_CASE("a program that closes its connection and goes on is killed") {
  const test::TemporaryDirectory files;
  const auto number = files.path("number");
  const auto ran =
      talk("ready; hear; echo $$ > " + number + "; exec < /dev/null > /dev/null; " + "sleep 600");
  CHECK(faultOf(ran) == "the platform's program has closed its connection, goes on, and is killed");
  std::string pid;
  std::ifstream(number) >> pid;
  CHECK_FALSE(std::filesystem::exists("/proc/" + pid));
}

TEST_CASE("a program that does not read its input is killed, and its actions have ended") {
  auto program = kSpokenProgram;
  const std::string given = "3 \"a";
  program.replace(program.find(given), given.size(), "3 \"" + std::string(60'000, 'a'));
  const auto executable = test::executableOf(
      program + "(defskill mission :body ((while true (// ((fly)) ((^ 0.001) (fly.interrupt))))))",
      false);
  const auto platform = runtime::processPlatform(
      *executable, {.command = {"/bin/sh", "-c", kSpoken + "ready; sleep 600"}, .directory = "/"},
      [] { return false; });
  REQUIRE(platform);
  const auto ran = test::runInRealTime(*executable, **platform, {.grace = 1'000'000});
  CHECK(ran.result.end == End::Lost);
  CHECK(std::ranges::any_of(ran.remarks, [](const auto& remark) {
    return remark.text.ends_with("the platform's program does not read its input");
  }));
}

TEST_CASE("a program that does not end after the run is killed with what it has started") {
  const test::TemporaryDirectory files;
  const auto number = files.path("number");
  const auto ran = talk("sleep 600 & echo $! > " + number + "; ready; hear; " + kThere +
                            "trap '' TERM; while :; do sleep 600; done",
                        {.grace = runtime::kSecond / 20});
  CHECK(faultOf(ran) == "the platform's program did not end in time; it is killed");
  std::string pid;
  std::ifstream(number) >> pid;
  // It is killed, but nobody here waits for its end: a test that fails never ends.
  const auto lives = [&] {
    std::ifstream stat("/proc/" + pid + "/stat");
    std::string word;
    for (int i = 0; i < 3; ++i) stat >> word;
    return stat && word != "Z";
  };
  while (lives()) std::this_thread::yield();
}
