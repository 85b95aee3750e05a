#include "report/run/read_recording.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace proskill;

namespace {

/// What is read of a trace: its mission, and its steps and starts of actions; or the error.
std::string readAs(const std::string& text) {
  const auto program = test::programOfText("(defskill m :body ((^ 1)))");
  std::string main;
  const auto run = report::readRecording(text, program, main);
  if (!run) return run.error();
  auto said = fmt::format("{}:", main);
  for (const auto& step : run->steps) said += fmt::format(" {}@{}", step.what.actor, step.date);
  for (const auto& call : run->calls)
    said += fmt::format(" {}({}) after {}", call.skill, fmt::join(call.arguments, ","), call.after);
  return said;
}

std::string step(const std::string& actor, int seconds, const std::string& more = "") {
  return fmt::format(R"({{"actor":"{}","date":{{"exact":"{}"}}{}}})", actor, seconds, more);
}

std::string traceOf(const std::string& steps) {
  return R"({"verdict":"recorded","initial":{"steps":"1"},"steps":[)" + steps + R"(],"main":"m"})";
}

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

} // namespace

TEST_CASE("steps and starts of actions are read in their order") {
  const auto started = step("a", 1, R"(,"remark":"started","action":{"arguments":["x",2]})");
  CHECK(readAs(traceOf("")) == "m:");
  CHECK(readAs(traceOf(step("m", 1) + "," + started + "," + step("a", 2))) ==
        "m: m@1000000000 a@2000000000 a(x,2) after 1");
}

TEST_CASE("a recording without its end is read up to its last whole line") {
  const std::string head = R"({"verdict":"recorded","main":"m","steps":[)";
  CHECK(readAs(head + "\n" + step("m", 1) + ",\n" + step("m", 2) + ",\n{\"act") ==
        "m: m@1000000000 m@2000000000");
  CHECK(readAs(head) == "m:");
  CHECK(readAs("{\"verdict\":\"recor") == "it is not JSON");
}

TEST_CASE("what is no recording has an error") {
  CHECK(readAs(traceOf("3")) == "a step must be an object");
  CHECK(readAs(traceOf("{}")) == "a step has no date in whole nanoseconds");
  CHECK(readAs(R"({"verdict":"recorded"})") == "it has no steps");
  CHECK(readAs(R"({"verdict":"recorded","steps":{"a":{}}})") == "it has no steps");
  CHECK(readAs(R"({"verdict":"violated","steps":[]})") == "it is not a recorded run");
  CHECK(readAs(traceOf(step("m", 1, R"(,"x":)" + nested(100'000)))) ==
        "its values are nested too deeply");
  CHECK(readAs(nested(100'000)) == "its values are nested too deeply");
  CHECK(readAs("[]") == "it has no steps");
}
