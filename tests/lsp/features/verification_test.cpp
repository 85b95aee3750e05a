#include "tests/lsp/support/lamp.h"
#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <fstream>
#include <thread>

namespace proskill::test::verification_test {

using namespace lamp;

namespace {

Session::Options withWorker(std::vector<std::string> command) {
  Session::Options options;
  options.worker = std::move(command);
  return options;
}

/// The output of a shell that replaces the verifying process.
Session::Options withShell(const std::string& script) {
  return withWorker({"/bin/sh", "-c", script});
}

/// Waits until a process has ended; fails if it does not.
bool hasGone(int process) {
  for (int i = 0; i < 6000; ++i) {
    if (kill(process, 0) != 0 && errno == ESRCH) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

int numberIn(const std::string& path) {
  int number = 0;
  while (number == 0) std::ifstream(path) >> number;
  return number;
}

} // namespace

TEST_CASE("verification is of the texts that the editor holds, in all files") {
  Session session;
  openLamp(session, kBad);
  auto bad = session.result("proskill/verify", verifying(kMain));
  CHECK(bad["program"] == kMain);
  CHECK(bad["texts"] ==
        Json::array({{{"uri", kMain}, {"version", 1}}, {{"uri", kLamp}, {"version", 1}}}));
  CHECK(verdictOn(bad, "lamp.no_forbidden_transition") == "violated");
  session.change(kLamp, 2, rangeOf(1, 24, 24), " (On Off)");
  auto fixed = session.result("proskill/verify", verifying(kLamp));
  CHECK(fixed["texts"][1]["version"] == 2);
  CHECK(verdictOn(fixed, "lamp.no_forbidden_transition") == "holds");
}

TEST_CASE("verification answers what was asked for, and its progress ends") {
  Session session;
  openLamp(session, kBad);
  auto params = verifying(kMain, Json::array({"lamp"}));
  params["workDoneToken"] = "t";
  auto result = session.result("proskill/verify", params);
  REQUIRE(result["verdicts"].size() == 1);
  CHECK(result["verdicts"][0]["good"] == false);
  CHECK(result["verdicts"][0]["location"]["range"] == rangeOf(0, 7, 11));
  CHECK(result["exploration"]["classes"] > 0);
  CHECK(session.notified("$/progress")["value"]["kind"] == "begin");
  Json last;
  do last = session.notified("$/progress")["value"];
  while (last["kind"] == "report");
  CHECK(last["kind"] == "end");
}

TEST_CASE("what cannot be verified is an error with a reason") {
  Session session;
  openLamp(session, kGood);
  auto messageOf = [&](const Json& params) {
    auto answer = session.ask("proskill/verify", params);
    INFO(answer.dump());
    REQUIRE(answer.contains("error"));
    CHECK(answer["error"]["code"] == -32803);
    return answer["error"]["message"].get<std::string>();
  };
  CHECK(messageOf(verifying(kMain, Json::array({"lmp"}))) == "no property is called `lmp`");
  session.change(kMain, 2, nullptr, "(defevent on :effects (lmp On))");
  CHECK(messageOf(verifying(kMain)).starts_with("the program has errors: "));
  CHECK(session.ask("proskill/verify", Json::object())["error"]["code"] == -32602);
}

TEST_CASE("beyond its limits a verification is inconclusive") {
  Session session;
  openLamp(session, kGood);
  auto params = verifying(kMain);
  params["limits"] = {{"classes", 1}};
  auto result = session.result("proskill/verify", params);
  CHECK(verdictOn(result, "lamp.no_forbidden_transition") == "inconclusive");
  CHECK(result["verdicts"][0]["reason"] == "the limit of classes was reached");
}

TEST_CASE("a verdict that a limit left open names the setting that raises it") {
  Session::Options options;
  options.initializationOptions = {{"verify", {{"live", false}, {"requestSeconds", 1e-6}}}};
  Session session(options);
  openLamp(session, kGood);
  const auto result = session.result("proskill/verify", verifying(kMain));
  CHECK(result["verdicts"][0]["reason"] ==
        "the time limit was reached; the setting `verify.requestSeconds` raises it");
}

TEST_CASE("in a workspace that is not trusted nothing is verified") {
  test::TemporaryDirectory directory;
  auto options = withShell("touch " + directory.path("started"));
  options.initializationOptions = {{"trusted", false}, {"verify", {{"delay", 0}}}};
  Session session(options);
  openLamp(session, kBad);
  CHECK(verdictsIn(session, "off")["message"].get<std::string>().find("not trusted") !=
        std::string::npos);
  CHECK(session.ask("proskill/verify", verifying(kMain))["error"]["code"] == -32803);
  CHECK(session.result("proskill/tests", document(kMain))["programs"].size() == 1);
  CHECK_FALSE(std::ifstream(directory.path("started")).good());
}

TEST_CASE("a process that verifies and fails is an error that is told, never a verdict") {
  for (const auto& [options, reason] :
       {std::pair(withWorker({"/does/not/exist"}), "could not be started"),
        std::pair(withWorker({"/bin/false"}), "exit code 1"),
        std::pair(withShell("kill -9 $$"), "signal 9"),
        std::pair(withShell("echo nonsense; exec sleep 1000"), "invalid message"),
        std::pair(withShell("echo '{\"report\": {}}'; exec sleep 1000"), "unknown form"),
        std::pair(withShell("echo '{}'"), "without a report")}) {
    Session session(options);
    openLamp(session, kGood);
    auto answer = session.ask("proskill/verify", verifying(kMain));
    INFO(answer.dump());
    REQUIRE(answer.contains("error"));
    CHECK(answer["error"]["message"].get<std::string>().find(reason) != std::string::npos);
    auto news = verdictsIn(session, "failed");
    CHECK(news["message"] == answer["error"]["message"]);
    CHECK(news["verdicts"].empty());
  }
}

TEST_CASE("a request that is cancelled ends its process; so does the end of the session") {
  test::TemporaryDirectory directory;
  const auto file = directory.path("pid");
  for (const bool cancelled : {true, false}) {
    std::filesystem::remove(file);
    Session session(withShell("echo $$ > " + file + "; exec sleep 1000"));
    openLamp(session, kGood);
    auto id = session.send("proskill/verify", verifying(kMain));
    const int child = numberIn(file);
    if (cancelled) {
      session.notify("$/cancelRequest", {{"id", id}});
      CHECK(session.answer(id)["error"]["code"] == -32800);
      CHECK(verdictsIn(session, "waiting")["message"] == "cancelled");
    } else {
      session.hangUp();
      CHECK(session.exitCode() == 1);
    }
    CHECK(hasGone(child));
  }
}

TEST_CASE("another server has the verdicts of the one before") {
  const TemporaryDirectory files;
  for (const bool known : {false, true}) {
    Session session(withWorker({PROSKILL_PROGRAM, "verify-worker", "--cache", files.path("kept")}));
    openLamp(session, kBad);
    const auto result = session.result("proskill/verify", verifying(kMain));
    CHECK((result["exploration"]["classes"] == 0) == known);
    CHECK(verdictOn(result, "lamp.no_forbidden_transition") == "violated");
    auto params = document(kMain);
    params["name"] = "lamp.no_forbidden_transition";
    CHECK(session.result("proskill/trace", params)["steps"].size() >= 2);
  }
}

TEST_CASE("a trace has places, dates and values, and says when it is stale") {
  Session session;
  openLamp(session, kBad);
  auto params = document(kMain);
  params["name"] = "lamp.no_forbidden_transition";
  CHECK(session.ask("proskill/trace", params)["error"]["code"] == -32803);
  session.result("proskill/verify", verifying(kMain));
  auto trace = session.result("proskill/trace", params);
  CHECK(trace["stale"] == false);
  CHECK(trace["verdict"] == "violated");
  CHECK(trace["initial"] == Json({{"lamp", "Off"}}));
  CHECK(trace["variables"] == Json::array({{{"name", "lamp"}, {"kind", "sv"}}}));
  REQUIRE(trace["steps"].size() >= 2);
  CHECK(trace["actors"][0] == Json({{"name", "on"}, {"kind", "event"}, {"skill", nullptr}}));
  const auto& first = trace["steps"][0];
  CHECK(first["actor"] == "on");
  CHECK(first["location"]["range"] == rangeOf(1, 10, 12));
  CHECK(first["changes"] ==
        Json::array({{{"variable", "lamp"}, {"before", "Off"}, {"after", "On"}}}));
  CHECK(first["earliest"]["exact"] == "0");
  CHECK(first["latest"] == nullptr);
  session.change(kLamp, 2, rangeOf(0, 0, 0), "; \n");
  CHECK(session.result("proskill/trace", params)["stale"] == true);
}

TEST_CASE("two programs have verdicts of their own, also in a file of both") {
  Session session;
  openLamp(session, kBad);
  const std::string other = "file:///w/other.proskill";
  session.open(other, kGood);
  auto good = session.result("proskill/verify", verifying(other));
  auto bad = session.result("proskill/verify", verifying(kMain));
  CHECK(verdictOn(good, "lamp.no_forbidden_transition") == "holds");
  CHECK(verdictOn(bad, "lamp.no_forbidden_transition") == "violated");
  CHECK(verdictsIn(session, "done", other)["counts"]["errors"] == 0);
  CHECK(verdictsIn(session, "done", kMain)["counts"]["errors"] == 1);
  CHECK(session.result("proskill/tests", Json::object())["programs"].size() == 2);
  session.close(kLamp);
  session.close(kMain); // last: it is not on disk, so it would be gone before the program is closed
  CHECK(verdictsIn(session, "off", kMain)["message"] == "the program is not open any more");
}

TEST_CASE("what there is to verify is a tree with places") {
  Session session;
  openLamp(session, kBad);
  auto program = session.result("proskill/tests", document(kMain))["programs"][0];
  CHECK(program["uri"] == kMain);
  CHECK(program["error"] == nullptr);
  const auto& lamp = program["subjects"][0];
  CHECK(lamp["id"] == "lamp");
  CHECK(lamp["kind"] == "sv");
  CHECK(lamp["location"] == Json({{"uri", kLamp}, {"range", rangeOf(0, 7, 11)}}));
  CHECK(lamp["properties"][0]["id"] == "lamp.no_forbidden_transition");
  session.change(kMain, 2, nullptr, "(defevent on :effects (lmp On))");
  auto broken = session.result("proskill/tests", document(kMain))["programs"][0];
  CHECK(broken["error"].get<std::string>().starts_with("the program has errors"));
  CHECK(broken["subjects"].empty());
}

} // namespace proskill::test::verification_test
