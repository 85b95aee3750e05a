#include "runtime/platform/json_place.h"
#include "runtime/platform/messages.h"
#include "runtime/platform/settings.h"
#include "tests/runtime/run_of.h"

#include <catch2/catch.hpp>

using namespace proskill;
using Catch::StartsWith;

namespace {

const std::string kProgram = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill fly :action (fly) :interrupt () :success there :failure lost)
  (defskill mission :success done :body ((fly) (success done))))";

std::string textOf(const std::optional<runtime::FileError>& error) {
  return error ? error->text() : "";
}

std::string platformError(const std::string& text) {
  const auto executable = test::executableOf(kProgram, false);
  auto settings = defaultSettings(*executable);
  return textOf(readPlatform(text, executable->model, settings));
}

std::string scriptError(const std::string& text) {
  const auto executable = test::executableOf(kProgram, false);
  auto settings = defaultSettings(*executable);
  return textOf(readScript(text, executable->model, settings));
}

/// The place of the value with this JSON pointer.
std::string placeOf(const std::string& text, const std::string& pointer) {
  const auto file = runtime::Json::parse(text);
  return runtime::placeOfPart(text, file, &file.at(runtime::Json::json_pointer(pointer))).text();
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

TEST_CASE("the kind of a platform file is checked at its place") {
  CHECK(runtime::platformKind("{}") == "simulated");
  CHECK(runtime::platformKind(R"({"kind": "library"})") == "library");
  const auto kind = runtime::platformKind("{\n  \"kind\": \"robot\"}");
  REQUIRE_FALSE(kind);
  CHECK_THAT(kind.error().text(), StartsWith("2:11: `kind` must be `simulated`, "));
}

TEST_CASE("the library of a platform file has its place") {
  const auto executable = test::executableOf(kProgram, false);
  runtime::LibrarySettings settings;
  REQUIRE(readLibraryPlatform("{\"kind\": \"library\",\n \"library\": \"librobot.so\"}",
                              executable->model, settings) == std::nullopt);
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
  const auto file = runtime::Json::parse(text);
  CHECK(runtime::placeOfPart(text, file, &file["a"]["b"][0]).text() == "1:49");
  CHECK(runtime::placeOfPart(text, file, &text).text() == "1:1");
}

TEST_CASE("a deeply nested file is searched to its end") {
  constexpr int kDepth = 100'000;
  const auto text =
      "{\"b\": 1, \"a\": " + std::string(kDepth, '[') + std::string(kDepth, ']') + "}";
  const auto file = runtime::Json::parse(text);
  CHECK(runtime::placeOfPart(text, file, &file["b"]).text() == "1:7");
  CHECK(runtime::placeOfPart(text, file, &text).text() == "1:1");
}

TEST_CASE("a file that is nested too deep is refused, not copied until the stack is full") {
  constexpr int kDepth = 200'000;
  const auto list = std::string(kDepth, '[') + std::string(kDepth, ']');
  const auto text = "{\"a\": " + list + ", \"b\": 1, \"c\": 2}";
  CHECK(runtime::parsedText(text).is_discarded());
  CHECK(runtime::platformKind(text).error().text() == "1:1: it is nested too deep");
  CHECK_FALSE(runtime::readMessage(text));
  CHECK(runtime::parsedText("{\"a\": \"\\\"" + list + "\"}").is_object());
}
