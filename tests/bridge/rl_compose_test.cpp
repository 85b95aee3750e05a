#include "bridge/rl/import.h"
#include "tests/bridge/errors_text.h"
#include "tests/bridge/verdicts.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace proskill;
using namespace proskill::test;
using bridge::rl::importSkillsets;

namespace rl_compose {

namespace {

const std::string kRobot = R"(
skillset robot {
  resource r { state { A B } initial A transition all }
  skill a { success ok {} failure ko {} }
  skill b { success ok {} failure ko {} }
  skill good { success ok {} }
  skill move { input { to: Pose by: float } success ok {} failure ko {} }
}
)";

std::string errorsIn(const std::string& text) {
  return errorsText(importSkillsets(
      MemoryFiles({{"robot.rl", kRobot}, {"main.rlc", "include \"robot.rl\"\n" + text}}),
      "main.rlc", {}));
}

bridge::Imported importedOf(const std::string& text) {
  const auto made = importSkillsets(
      MemoryFiles({{"robot.rl", kRobot}, {"main.rlc", "include \"robot.rl\"\n" + text}}),
      "main.rlc", {});
  if (!made) FAIL(errorsIn(text));
  return *made;
}

/// What the verifier says of a composite: its results, the skills that run, and which run at once.
std::string runsOf(const std::string& term, const std::string& more = "") {
  const auto text = importedOf(more + "def Main(x: robot, yes: bool) { " + term + " }\n" +
                               "def Mission(x: robot, yes: bool) { Main(x, yes) }\n")
                        .text;
  const auto found =
      verified(text + questions({{"a", {"a"}}, {"b", {"b"}}, {"good", {"good"}}}, false));
  REQUIRE(found);
  return inWords(*found);
}

std::string words(const std::string& results, const std::string& started,
                  const std::string& together = "") {
  return results + "\n  started:" + started + "\n  together:" + together;
}

} // namespace

TEST_CASE("a composite of skills becomes a composite skill") {
  const auto imported = importedOf("def go(x: robot, to: Pose, by: float) {\n"
                                   "  x.move(to, by) > robot.a() + robot.good()\n}\n");
  CHECK(imported.text.contains(R"(; from main.rlc:2:5 def go
(defskill go
  :input ($to string $by float)
  :success done
  :failure failed
  :body
    (
     ; from main.rlc:3:3 call move
     (move to $to by $by)
     (if (/= move.status success)
        (goto next))
     ; from main.rlc:3:20 call a
     (a)
     (if (/= a.status success)
        (goto next))
     (goto done)
     (label next)
     ; from main.rlc:3:32 call good
     (good)
     (if (/= good.status success)
        (failure failed))
     (label done)
     (success done)))
)"));
}

TEST_CASE("a composite with parameters that nothing calls is called with any truth values") {
  const auto text = importedOf("def go(x: robot, to: Pose, by: float, now: bool) {\n"
                               "  if now then x.move(to, by) else x.good() end\n}\n")
                        .text;
  CHECK(text.contains("(defsv go_now\n  :states (Yes No)\n  :init (Yes No))"));
  CHECK(text.contains("    ((if (go_now Yes)\n        (go to \"to\" by 0 now true)\n      else\n"
                      "        (go to \"to\" by 0 now false))"));
  CHECK(errorsIn("def m(a: bool, b: bool, c: bool, d: bool, e: bool) { a }") ==
        "main.rlc:2:5: nothing calls `m`, which has more than 4 parameters of type `bool`\n");
}

TEST_CASE("the operators of composites have these results") {
  CHECK(runsOf("x.a() > x.b()") == words("success failure ", " a b"));
  CHECK(runsOf("x.good() > x.b()") == words("success failure ", " b good"));
  CHECK(runsOf("x.good() + x.b()") == words("success ", " good"));
  CHECK(runsOf("x.a() + x.good()") == words("success ", " a good"));
  CHECK(runsOf("x.a() | x.b()") == words("success failure ", " a b", " a&b"));
  CHECK(runsOf("x.a() ! x.good()") == words("success failure ", " a good", " a&good"));
  CHECK(runsOf("if x.good() then x.a() else x.b() end") == words("success failure ", " a good"));
  CHECK(runsOf("if yes then x.good() elif x.a() then x.good() else x.b() end") ==
        words("success failure ", " a b good"));
  CHECK(runsOf("x.good() and yes or x.good()") == words("success ", " good"));
  CHECK(runsOf("(x.a() ! x.good()) + x.good()") == words("success ", " a good", " a&good"));
  CHECK(runsOf("other() > x.b()", "def other() { robot.good() }\n") ==
        words("success failure ", " b good"));
}

TEST_CASE("methods that are declared only and calls of ROS become basic skills") {
  const auto text = importedOf("type Data\ndec plan(d: Data)\n"
                               "def m(d: Data) { plan(d) > ros.publish(\"/go\", d) > "
                               "ros.action(\"/dock\") }\n")
                        .text;
  CHECK(text.contains("(defskill plan\n  :input ($d string)\n  :action (plan $d)\n"));
  CHECK(text.contains("  :action (ros_publish \"/go\" $argument_1)\n  :success done)"));
  CHECK_FALSE(text.contains("ros_publish__go.status"));
  CHECK(text.contains("  :action (ros_action \"/dock\")\n  :success done\n  :failure failed)"));
}

TEST_CASE("errors in composites have places") {
  CHECK(errorsIn("def m() { robot.fly() }") == "main.rlc:2:11: unknown skill `robot.fly`\n");
  CHECK(errorsIn("def m() { fly() }") == "main.rlc:2:11: unknown composite `fly`\n");
  CHECK(errorsIn("def m(d: Data) { d }") ==
        "main.rlc:2:18: `d` is neither a call nor a parameter of type `bool`\n");
  CHECK(errorsIn("def m(d: Data) { robot.move(d) }") ==
        "main.rlc:2:18: `move` takes 2 arguments, not 1\n");
  CHECK(errorsIn("def m(d: Data) { robot.move(d, d) }") ==
        "main.rlc:2:32: `d` is of type `string` in the program; `float` is needed\n");
  CHECK(errorsIn("def m() { n() }\ndef n() { m() }") == "main.rlc:2:5: `m` calls itself\n");
  CHECK(errorsIn("def m(x: robot, y: robot) { x.a() | y.a() }") ==
        "main.rlc:2:17: two robots with `robot` are not supported: the program has one\n");
  CHECK(errorsIn("def m(d: Data) { n(d) }\ndef n(x: robot) { x.a() }") ==
        "main.rlc:2:20: a robot with `robot` is needed\n");
  CHECK(errorsIn("def m() { ros.call(\"/x\") }") ==
        "main.rlc:2:15: after `ros.` comes `publish`, `service` or `action`\n");
  CHECK(errorsIn("def m() { robot.a() > }").starts_with("main.rlc:2:23: "));
  CHECK(errorsIn("def m() { " + std::string(200, '(')).contains("nested too deep"));
}

TEST_CASE("a long chain of composites is no recursion") {
  constexpr int kCalls = 50'000;
  std::string text;
  for (int i = 0; i < kCalls; ++i) text += fmt::format("def m{}() {{ m{}() }}\n", i, i + 1);
  CHECK(
      importedOf(text + fmt::format("def m{}() {{ robot.a() }}", kCalls)).text.contains("m49999"));
  CHECK(errorsIn(text + fmt::format("def m{}() {{ m0() }}", kCalls)) ==
        "main.rlc:2:5: `m0` calls itself\n");
}

TEST_CASE("the summary says that the operators of composites have no published meaning") {
  CHECK(importedOf("def m() { robot.a() }").summary.back().contains("no published meaning"));
}

} // namespace rl_compose
