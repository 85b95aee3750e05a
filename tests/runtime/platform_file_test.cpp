#include "runtime/platform/messages.h"
#include "runtime/platform/ros.h"
#include "runtime/platform/settings.h"
#include "tests/runtime/run_of.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

namespace proskill::test::platform_file_test {

using Catch::StartsWith;

namespace {

const std::string kProgram = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill fly :action (fly) :interrupt () :success there :failure lost)
  (defskill mission :success done :body ((fly) (success done))))";

/// One error a line.
std::string textOf(const runtime::FileErrors& errors) {
  std::string lines;
  for (const auto& error : errors) lines += (lines.empty() ? "" : "\n") + error.text();
  return lines;
}

std::string platformError(const std::string& text) {
  const auto executable = test::executableOf(kProgram, false);
  auto settings = defaultSettings(*executable);
  const auto file = runtime::JsonFile::parse(text);
  return textOf(file ? readSimulation(*file, executable->model, settings) : file.error());
}

std::string scriptError(const std::string& text) {
  const auto executable = test::executableOf(kProgram, false);
  auto settings = defaultSettings(*executable);
  return textOf(readScript(runtime::JsonFile::parse(text).value(), executable->model, settings));
}

/// The place of the value with this JSON pointer.
std::string placeOf(const std::string& text, const std::string& pointer) {
  const auto file = runtime::JsonFile::parse(text).value();
  return file.placeOf(&file.json().at(runtime::Json::json_pointer(pointer))).text();
}

} // namespace

TEST_CASE("errors of a platform file are at the key or the value that is wrong") {
  CHECK(platformError("{\n \"action\": {}}") ==
        "2:2: there is no member `action`; did you mean `actions`?");
  CHECK(platformError("{\"actions\": {\n  \"flie\": {}}}") ==
        "2:3: there is no basic skill `flie`");
  CHECK(platformError(R"({"actions": {"fly": {"results": {"there": 1, "gone": 2}}}})") ==
        "1:46: there is no result of `fly` `gone`");
  CHECK(platformError("{\"actions\": {\"fly\": {\n\"duration\": [3,\n 1]}}}") ==
        "2:13: `fly.duration` ends before it begins");
  CHECK(platformError(R"({"actions": {"fly": {"duration": [3, "long"]}}})") ==
        "1:38: `fly.duration` must be a number of seconds");
  CHECK_THAT(platformError(R"({"actions": {"fly": {"results": {"there": -1}}}})"),
             StartsWith("1:43: the weight of `there`"));
  CHECK(platformError(R"({"events": {"storm": [0, 1]}})") ==
        "1:22: `storm` may come again at once: let some time pass");
  CHECK(platformError(R"({"events": []})") == "1:12: `events` must be an object");
  CHECK(platformError("{\n\"events\": {,}}") == "2:12: it is not JSON");
  CHECK(platformError("{\n\"time_scale\": 1e999}") == "2:15: the number is too large");
  CHECK(platformError("[]") == "1:1: it is not an object");
  CHECK(platformError(R"({"events": {"storm": null}})").empty());
}

TEST_CASE("errors of a script are at the value that is wrong") {
  CHECK(scriptError("{\"signals\": [{\"at\": 1, \"event\": \"storm\"},\n{\"at\": 2, \"event\": "
                    "\"strom\"}]}") == "2:20: there is no event `strom`; did you mean `storm`?");
  CHECK(scriptError(R"({"signals": [{"at": 1}]})") ==
        "1:14: a signal must have `at` and either `event` or `interrupt`");
  CHECK(scriptError(R"({"actions": {"fly": [{"after": 1}, {"result": "gone"}]}})") ==
        "1:47: there is no result of `fly` `gone`");
}

TEST_CASE("all errors of a platform file are reported, in the order of the file") {
  CHECK(platformError(R"({"event": {}, "actions": {
    "fly": {"speed": 1, "stops": 3, "duration": [2, 1], "results": {"there": -1, "gone": 1}},
    "flie": {}}, "events": {"storm": [0, 1], "calm": null}})") ==
        "1:2: there is no member `event`; did you mean `events`?\n"
        "2:13: there is no member `speed`\n"
        "2:34: `fly.stops` is not [LEAST, MOST]\n"
        "2:49: `fly.duration` ends before it begins\n"
        "2:78: the weight of `there` must be a natural number up to a million\n"
        "2:82: there is no result of `fly` `gone`\n"
        "3:5: there is no basic skill `flie`\n"
        "3:38: `storm` may come again at once: let some time pass\n"
        "3:46: there is no event `calm`");
  CHECK(scriptError(R"({"actions": {"fly": [{"after": -1}, {"result": "gone"}]},
                        "signals": [{"at": 1}, {"at": 2, "event": "calm"}]})") ==
        "1:32: `fly.after` is not between 0 and 1e9 s\n"
        "1:48: there is no result of `fly` `gone`\n"
        "2:37: a signal must have `at` and either `event` or `interrupt`\n"
        "2:67: there is no event `calm`");
}

TEST_CASE("all errors of a platform file of ROS are reported") {
  const auto executable = test::executableOf(kProgram, false);
  runtime::ProcessSettings settings;
  const auto file = runtime::JsonFile::parse(R"({"kind": "ros2", "domain": 300, "restarts": -1,
    "actions": {"fly": {"action": "/fly", "type": "Fly", "goal": {"x": [], "y": "$to"},
                        "results": {"succeeded": "their", "lost": "lost"}}, "land": {}},
    "variables": {"sky": {"topic": "", "type": "std_msgs/Bool", "field": "data",
                          "values": [{"value": "Rainy"}, {"above": "x", "value": "Clear"}]}},
    "events": {"storm": {"field": "data", "below": 3}}})");
  const auto program = test::programOfText(kProgram);
  CHECK(textOf(readRosPlatform(file.value(), runtime::Ros::Two, program, executable->model,
                               settings)) ==
        "1:28: `domain` must be a natural number up to 232\n"
        "1:45: `restarts` must be a natural number up to a million\n"
        "2:51: `fly`: the type `Fly` must have the form package/action/Type\n"
        "2:72: `fly.goal.x` must be a number, a string, true or false\n"
        "2:81: there is no argument of the action of `fly` `$to`\n"
        "3:50: there is no result of `fly` `their`\n"
        "3:59: there is no terminal state `lost`\n"
        "3:77: there is no basic skill `land`\n"
        "4:36: `sky`: `topic` must not be empty\n"
        "4:48: `sky`: the type `std_msgs/Bool` must have the form package/msg/Type\n"
        "5:48: there is no value of `sky` `Rainy`\n"
        "5:68: `sky`: `above` must be a number\n"
        "6:25: `storm`: `topic` is missing\n"
        "6:25: `storm`: `type` is missing");
}

TEST_CASE("a file with many errors shows the first of them") {
  std::string text = "{\"actions\": {";
  for (int i = 0; i < 150; ++i) text += fmt::format("\n\"a{}\": {{}},", i);
  text.back() = '}';
  const auto errors = platformError(text + "}");
  CHECK_THAT(errors, StartsWith("2:1: there is no basic skill `a0`\n3:1: "));
  CHECK_THAT(errors, Catch::EndsWith("`a99`\n50 more errors are not shown"));
}

TEST_CASE("the kind of a platform file is checked at its place") {
  using runtime::PlatformFile;
  using runtime::PlatformKind;
  CHECK(PlatformFile::parse("{}").value().kind == PlatformKind::Simulated);
  CHECK(PlatformFile::parse(R"({"kind": "library"})").value().kind == PlatformKind::Library);
  CHECK(textOf(PlatformFile::parse(R"({"command": ["robot"]})").error()) ==
        "1:13: `\"kind\": \"process\"` is missing: a simulation has no `command`");
  CHECK(textOf(PlatformFile::parse(R"({"library": "robot.so"})").error()) ==
        "1:13: `\"kind\": \"library\"` is missing: a simulation has no `library`");
  const auto file = PlatformFile::parse("{\n  \"kind\": \"robot\"}");
  REQUIRE_FALSE(file);
  CHECK_THAT(textOf(file.error()), StartsWith("2:11: `kind` must be `simulated`, "));
}

TEST_CASE("the library of a platform file has its place") {
  const auto executable = test::executableOf(kProgram, false);
  runtime::LibrarySettings settings;
  const auto file =
      runtime::JsonFile::parse("{\"kind\": \"library\",\n \"library\": \"librobot.so\"}");
  REQUIRE(textOf(readLibraryPlatform(file.value(), executable->model, settings)) == "");
  CHECK(settings.place.text() == "2:13");
}

TEST_CASE(
    "a place is found behind strings with brackets, escapes and characters of several bytes") {
  const std::string text = "{\"a}\\\"]\": [\"{\", \"\\\\\"], \"\\u0062\": {\"é\": [[], {}, 3]}}";
  CHECK(placeOf(text, "") == "1:1");
  CHECK(placeOf(text, "/b/é/2") == "1:49");
  CHECK(placeOf("\xEF\xBB\xBF{\"a\":\n  [1, 22]}", "/a/1") == "2:7");
}

TEST_CASE("of members with the same key the kept one has a place, whatever the others are") {
  const std::string text = R"({"a": [1, 2], "a": {"b": {"c": 1}}, "a": {"b": [7]}})";
  const auto file = runtime::JsonFile::parse(text).value();
  CHECK(file.placeOf(&file.json()["a"]["b"][0]).text() == "1:49");
  CHECK(file.placeOf(&text).text() == "1:1");
}

TEST_CASE("a large file takes time in proportion to its size") {
  std::string text = "{\"actions\": {";
  constexpr int kMembers = 200'000; // minutes, if each were searched among those before
  for (int i = 0; i < kMembers; ++i) text += fmt::format("\"a{}\": {{}},", i);
  text.back() = '}';
  CHECK_THAT(platformError(text + "}"), Catch::EndsWith("\n199900 more errors are not shown"));
}

TEST_CASE("a file that is nested too deep is refused") {
  constexpr int kDepth = 200'000;
  const auto list = std::string(kDepth, '[') + std::string(kDepth, ']');
  const auto text = "{\"a\": " + list + ", \"b\": 1, \"c\": 2}";
  CHECK(runtime::parsedText(text).is_discarded());
  CHECK(textOf(runtime::PlatformFile::parse(text).error()) == "1:1: it is nested too deep");
  CHECK_FALSE(runtime::readMessage(text));
  CHECK(runtime::parsedText("{\"a\": \"\\\"" + list + "\"}").is_object());
}

} // namespace proskill::test::platform_file_test
