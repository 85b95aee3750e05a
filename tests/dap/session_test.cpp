#include "tests/dap/client.h"
#include "tests/support/endless_program.h"
#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace proskill;
using test::DapClient;

namespace {

/// A lamp that a skill switches on, and off again, which its variable forbids.
const std::string kLamp = "(defsv lamp :states (On Off) :init Off :transitions ((Off On)))\n"
                          "(defskill switch_on :time_interval [2,5] :action (a)\n"
                          "  :success lit (:effects (lamp On)))\n"
                          "(defskill mission\n"
                          "  :body ((switch_on)\n"
                          "         (set (lamp Off))))\n";
const std::string kProperty = "lamp.no_forbidden_transition";

struct Files {
  test::TemporaryDirectory directory;
  std::string program = directory.write("lamp.proskill", kLamp);
};

Json breakpointsAt(const std::string& path, const std::vector<int>& lines) {
  Json breakpoints = Json::array();
  for (auto line : lines) breakpoints.push_back({{"line", line}});
  return {{"source", {{"path", path}}}, {"breakpoints", breakpoints}};
}

std::string valueOf(DapClient& client, const std::string& variable) {
  return client.result("evaluate", {{"expression", variable}})["result"];
}

/// Sends a request, and returns the stop that follows.
Json move(DapClient& client, const std::string& command, Json arguments = {{"threadId", 1}}) {
  client.result(command, std::move(arguments));
  return client.event("stopped");
}

/// The lines of the steps, by single steps to the end.
std::vector<int> linesForward(DapClient& client, Json stop) {
  std::vector<int> lines;
  while (!stop.contains("description")) {
    lines.push_back(client.top(stop)["line"]);
    stop = move(client, "next");
  }
  return lines;
}

} // namespace

TEST_CASE("a property's trace is stepped through, forth and back") {
  Files files;
  DapClient client;
  auto stop = client.start({{"program", files.program}, {"property", kProperty}});
  CHECK(stop["reason"] == "entry");
  CHECK(client.values(client.top(stop), "State variables")["lamp"] == "Off");
  const auto lines = linesForward(client, stop);
  REQUIRE(lines.size() >= 4);
  CHECK(lines.back() == 6);
  CHECK(std::ranges::count(lines, 3) == 1);
  stop = move(client, "next");
  CHECK(stop["reason"] == "end");
  CHECK(stop["description"] == "lamp makes no forbidden move: violated");
  CHECK(valueOf(client, "lamp") == "Off");
  move(client, "stepBack");
  CHECK(valueOf(client, "lamp") == "On");
  stop = move(client, "reverseContinue");
  CHECK(stop["reason"] == "entry");
  CHECK(client.result("proskill/position")["position"] == 0);
  CHECK(linesForward(client, stop) == lines);
  client.result("disconnect");
  CHECK(client.ending() == "it ended with exit code 0");
}

TEST_CASE("a run stops at breakpoints, both ways, and where a variable changes") {
  Files files;
  DapClient client;
  client.start({{"program", files.program}, {"property", kProperty}});
  auto set = client.result("setBreakpoints", breakpointsAt(files.program, {1, 6}))["breakpoints"];
  CHECK(set[0]["verified"] == false);
  CHECK(set[0]["message"] == "no step of the trace is at this line");
  CHECK(set[1]["verified"] == true);
  auto stop = move(client, "continue");
  CHECK(stop["reason"] == "breakpoint");
  CHECK(client.top(stop)["line"] == 6);
  CHECK(valueOf(client, "lamp") == "On");
  CHECK(move(client, "continue")["reason"] == "end");
  CHECK(move(client, "reverseContinue")["reason"] == "breakpoint");
  client.result("setBreakpoints", breakpointsAt(files.program, {}));
  CHECK(move(client, "restart")["reason"] == "entry");
  CHECK(client.result("dataBreakpointInfo", {{"name", "lam"}})["dataId"] == nullptr);
  const auto id = client.result("dataBreakpointInfo", {{"name", "lamp"}})["dataId"];
  client.result("setDataBreakpoints", {{"breakpoints", Json::array({{{"dataId", id}}})}});
  CHECK(move(client, "continue")["reason"] == "data breakpoint");
  CHECK(valueOf(client, "lamp") == "On");
}

TEST_CASE("threads are who acts, the stack is what each did and when") {
  Files files;
  DapClient client;
  client.start({{"program", files.program}, {"property", kProperty}});
  client.result("setBreakpoints", breakpointsAt(files.program, {6}));
  move(client, "continue");
  std::map<std::string, int> ids;
  const auto threads = client.result("threads");
  for (const auto& thread : threads["threads"]) ids[thread["name"]] = thread["id"];
  REQUIRE(ids.contains("mission"));
  REQUIRE(ids.contains("switch_on"));
  auto stack = client.result("stackTrace", {{"threadId", ids["switch_on"]}});
  REQUIRE(stack["totalFrames"] >= 2);
  const auto last = stack["stackFrames"].front();
  CHECK(last["name"] == "2 s: succeeds with lit");
  CHECK(last["line"] == 3);
  CHECK(last["source"]["path"] == std::filesystem::canonical(files.program).string());
  auto time = client.values(last, "Time");
  CHECK(time["now"] == "2 s");
  CHECK(time["after"] == "2 s");
  CHECK(time["possible"] == "[2 s, 5 s]");
  CHECK(client.values(last, "State variables")["lamp"] == "On");
  // A frame shows the values at its own time.
  const auto first = stack["stackFrames"].back();
  CHECK(client.values(first, "State variables")["lamp"] == "Off");
  CHECK(client.values(first, "Skills").contains("switch_on.status"));
  const Json hover{{"expression", " lamp "}, {"frameId", first["id"]}};
  CHECK(client.result("evaluate", hover)["result"] == "Off");
  auto one = client.result("stackTrace",
                           {{"threadId", ids["switch_on"]}, {"startFrame", 1}, {"levels", 1}});
  CHECK(one["stackFrames"] == Json::array({stack["stackFrames"][1]}));
  CHECK(client.ask("evaluate", {{"expression", "x"}})["message"] == "there is no variable `x`");
}

TEST_CASE("a trace that was saved is replayed from its file") {
  Files files;
  const auto saved = files.directory.path("traces");
  const auto json = test::run(
      {PROSKILL_PROGRAM, "verify", files.program, "--save-traces", saved, "--format", "json"});
  const auto report = files.directory.write("report.json", json.out);
  for (const Json& launch : {Json{{"trace", saved + "/" + kProperty + ".json"}},
                             Json{{"trace", report}, {"property", kProperty}}}) {
    DapClient client;
    client.start(launch);
    const auto set = client.result("setBreakpoints", breakpointsAt(files.program, {6}));
    CHECK(set["breakpoints"][0]["verified"] == true);
    CHECK(client.top(move(client, "continue"))["line"] == 6);
  }
}

TEST_CASE("whoever replays a trace hears which files have been edited since") {
  Files files;
  const auto saved = files.directory.path("traces");
  const auto json = test::run(
      {PROSKILL_PROGRAM, "verify", files.program, "--save-traces", saved, "--format", "json"});
  const auto report = files.directory.write("report.json", json.out);
  const auto recording = files.directory.path("run.mcap");
  CHECK(test::run({PROSKILL_PROGRAM, "run", "--record", recording, files.program}).exitCode < 2);
  const auto isSaid = [&](const Json& launch) {
    DapClient client;
    client.start(launch);
    client.result("threads"); // after what is said at the start
    return client.said("has been edited since this trace was made");
  };
  const std::vector<Json> launches{{{"trace", saved + "/" + kProperty + ".json"}},
                                   {{"trace", report}, {"property", kProperty}},
                                   {{"trace", recording}}};
  for (const auto& launch : launches) CHECK_FALSE(isSaid(launch));
  std::ofstream(files.program, std::ios::app) << "; a comment\n";
  for (const auto& launch : launches) CHECK(isSaid(launch));
}

TEST_CASE("a recording is stepped through, forth and back, from any time on") {
  Files files;
  const auto endless = files.directory.write(
      "endless.proskill", "(defsv lamp :states (On Off) :init Off :transitions :all)\n"
                          "(defskill mission\n"
                          "  :body ((while true\n"
                          "           (^ 1) (set (lamp On))\n"
                          "           (^ 1) (set (lamp Off)))))\n");
  const auto recording = files.directory.path("run.mcap");
  const auto ran =
      test::run({PROSKILL_PROGRAM, "run", "--until", "2d", "--record", recording, endless});
  CHECK(ran.exitCode == 3);
  CHECK(std::filesystem::file_size(recording) > 50'000'000);
  for (const double from : {3'600.0, 100'000.0}) {
    DapClient client;
    auto stop = client.start({{"trace", recording}, {"from", from}});
    const auto total = client.result("proskill/position")["total"].get<int>();
    CHECK(total > 10'000);
    const auto line = client.top(stop)["line"];
    const auto lamp = valueOf(client, "lamp");
    for (int i = 0; i < 3; ++i) stop = move(client, "next");
    CHECK(valueOf(client, "mission.status") == "no_status");
    for (int i = 0; i < 3; ++i) stop = move(client, "stepBack");
    CHECK(client.top(stop)["line"] == line);
    CHECK(valueOf(client, "lamp") == lamp);
    client.result("proskill/goTo", {{"position", 9}});
    stop = client.event("stopped");
    const auto time = client.values(client.top(stop), "Time")["now"];
    INFO(time);
    CHECK(std::abs(std::stod(time) - from) < 1'500);
  }
}

TEST_CASE("in a simulation the user chooses what happens") {
  Files files;
  DapClient client;
  auto stop = client.start({{"program", files.program}, {"simulate", true}});
  CHECK(stop["reason"] == "entry");
  const auto set = client.result("setBreakpoints", breakpointsAt(files.program, {6}));
  CHECK(set["breakpoints"][0]["verified"] == true);
  CHECK(client.result("proskill/position")["total"] == nullptr);
  // Until the action runs, which may take two to five seconds.
  Json target;
  for (int i = 0; i < 20; ++i) {
    const auto targets = client.result("stepInTargets", {{"frameId", client.top(stop)["id"]}});
    for (const auto& it : targets["targets"])
      if (it["description"] == "succeeds with `lit`") target = it;
    if (!target.is_null()) break;
    stop = move(client, "next");
  }
  REQUIRE_FALSE(target.is_null());
  CHECK(target["line"] == 3);
  CHECK(target["window"] == "[2 s, 5 s]");
  move(client, "stepIn", {{"threadId", 1}, {"targetId", target["id"]}});
  CHECK(valueOf(client, "lamp") == "On");
  move(client, "stepBack");
  CHECK(valueOf(client, "lamp") == "Off");
  const auto again = client.result("proskill/choices");
  CHECK(again["simulation"] == true);
  CHECK(std::ranges::count(again["choices"], target) == 1);
  CHECK(client.ask("proskill/choose", {{"id", 1000}})["message"] == "there is no choice 1000");
  move(client, "proskill/choose", {{"id", target["id"]}});
  stop = move(client, "continue");
  CHECK(stop["reason"] == "breakpoint");
  CHECK(client.top(stop)["line"] == 6);
}

TEST_CASE("a recording that was cut off within a write is stepped through") {
  Files files;
  const auto recording = files.directory.path("run.json");
  const auto program = files.directory.write(
      "wait.proskill", "(defskill mission :success done\n  :body ((^ 1) (^ 1) (success done)))");
  const auto ran =
      test::run({PROSKILL_PROGRAM, "run", "--clock", "simulated", "--record", recording, program});
  REQUIRE(ran.exitCode == 0);
  std::ifstream whole(recording);
  std::string text{std::istreambuf_iterator<char>(whole), {}};
  text.resize(text.size() - 20);
  DapClient client;
  client.start({{"trace", files.directory.write("cut.json", text)}});
  CHECK(client.result("proskill/position")["total"].get<int>() == 3);
}

TEST_CASE("what cannot be launched is an error with a reason") {
  Files files;
  const auto broken = files.directory.write("broken.proskill", "(defsv");
  auto message = [](const Json& launch) {
    DapClient client;
    client.result("initialize", {{"adapterID", "proskill"}});
    auto answer = client.ask("launch", launch);
    CHECK(answer["success"] == false);
    return answer["message"].get<std::string>();
  };
  CHECK(message(Json::object()) == "`launch` needs a `program` or a `trace`");
  CHECK(message({{"program", "/does/not/exist"}}).starts_with("cannot read"));
  CHECK(message({{"program", broken}}).starts_with("the program has errors"));
  CHECK(message({{"program", files.program}, {"property", "x"}}) == "no property is called `x`");
  CHECK(message({{"trace", files.program}}).ends_with("is not valid JSON"));
  CHECK(message({{"program", files.program}, {"property", "program.time_progress"}}) ==
        "`program.time_progress` holds: there is no trace to replay");
}

TEST_CASE("what is no message is passed over, what is unknown is refused") {
  DapClient client;
  client.sendRaw("Content-Length: 3\r\n\r\n{{{");
  client.sendRaw(rpc::frame("[]"));
  client.sendRaw(rpc::frame(R"({"seq":1,"type":"request"})"));
  CHECK(client.ask("dance")["success"] == false);
  CHECK(client.ask("next")["message"] == "no session is running");
  client.result("initialize", {{"adapterID", "proskill"}, {"linesStartAt1", false}});
  CHECK(client.ask("launch", {{"program", 3}})["success"] == false);
  client.result("disconnect");
  CHECK(client.ending() == "it ended with exit code 0");
}

TEST_CASE("a disconnection ends a verification that is under way") {
  test::TemporaryDirectory directory;
  const auto program = directory.write("many.proskill", test::endlessProgram());
  DapClient client;
  client.result("initialize", {{"adapterID", "proskill"}, {"supportsProgressReporting", true}});
  client.send("launch", {{"program", program}, {"seconds", 600}});
  client.event("progressUpdate"); // the verifying process runs
  client.result("disconnect");
  CHECK(client.ending() == "it ended with exit code 0");
}
