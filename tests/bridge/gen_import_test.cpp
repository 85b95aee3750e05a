#include "analysis/program/program.h"
#include "bridge/gen/import.h"
#include "tests/bridge/errors_text.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace proskill::test;
using bridge::gen::importComponents;

namespace gen_import {

namespace {

using Files = std::map<std::string, std::string>;

std::string component(const std::string& inner) { return "component c {\n" + inner + "\n};\n"; }

std::string errorsIn(const Files& files) {
  return errorsText(importComponents(MemoryFiles(files), "main.gen", {}, {}));
}

std::string errorsIn(const std::string& text) { return errorsIn(Files{{"main.gen", text}}); }

bridge::Imported importedOf(const Files& files, const std::string& leaves = "{}") {
  const auto read = bridge::Leaves::read(leaves);
  REQUIRE(read);
  const auto imported = importComponents(MemoryFiles(files), "main.gen", *read, {});
  if (!imported) FAIL(errorsIn(files));
  return *imported;
}

bridge::Imported importedOf(const std::string& text, const std::string& leaves = "{}") {
  return importedOf(Files{{"main.gen", text}}, leaves);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string lastLine(const bridge::Imported& imported) { return imported.summary.back(); }

} // namespace

TEST_CASE("a service becomes a basic skill with its inputs and exceptions") {
  const auto imported = importedOf(component(R"(
exception e_sys { short code; string<128> what; }, e_range;
ids { struct s { double speed; unsigned long count; boolean on; } limits; };
attribute set(in limits.speed = 1.5: "m/s", in limits.count, in limits.on, out limits) { throw e_range; };
function look(in string<64> path = "a\"b": "file", in octet times, in double gains[3], out long seen) { codel l(); };
activity drive(inout double x) {
  doc "Drive" " on";
  task main;
  local sequence<double> way;
  codel<start> plan(in x, out way) yield go;
  async codel<go> drive(in way) yield pause::go, ether;
  codel<stop> halt() yield ether;
  throw e_sys, e_range;
};
task main { period 5 ms; codel<start> s(out ::ids) yield ether; };
port in double width;)"));
  CHECK(imported.text == R"(; The services of main.gen, by `proskill import gen`.

; from main.gen:5:11 attribute set
(defskill set_node
  :input ($speed float $count nat $on bool)
  :action (set $speed $count $on)
  :interruptible nil
  :success done
  :failure e_range)

; from main.gen:6:10 function look
(defskill look
  :input ($path string $times nat $gains string)
  :action (look $path $times $gains)
  :interruptible nil
  :success done)

; from main.gen:7:10 activity drive
(defskill drive
  :input ($x float)
  :action (drive $x)
  :interrupt ()
  :success done
  :failure (e_sys e_range))
)");
  CHECK(imported.exact);
  CHECK(imported.summary.front() == "not in the program: 1 port, 1 task, 4 codels, 2 outputs");
}

TEST_CASE("parts of the internal data with one name are several inputs with their types") {
  const auto imported = importedOf(component(R"(
ids { struct s { double max; long steps[4]; } linear, angular[2]; };
attribute set(in linear.max, in angular[1].max, in linear.steps[2], in linear.steps);)"));
  CHECK(imported.text.find("  :input ($max float $max_2 float $steps int $steps_2 string)\n"
                           "  :action (set $max $max_2 $steps $steps_2)\n") != std::string::npos);
}

TEST_CASE("a service that is interrupted watches a variable that the other one sets") {
  const auto imported = importedOf(component(R"(
activity a() { codel<start> s() yield pause::start, ether; interrupt b, c; };
activity b() { codel<start> s() yield pause::start, ether; };
activity c() { codel<start> s() yield pause::start, ether; interrupts b; };)"));
  CHECK(contains(imported.text, "(defskill a\n  :start ((b_replaced Yes) (c_replaced Yes))\n"));
  CHECK(contains(imported.text, "(defskill b\n  :start (b_replaced No)\n"
                                "  :invariant (not_replaced (:guard (b_replaced No)))\n"));
  CHECK(contains(imported.text, "(defskill c\n  :start ((c_replaced No) (b_replaced Yes))\n"));
  CHECK_FALSE(contains(imported.text, "a_replaced"));
  CHECK(imported.exact);
}

TEST_CASE("the order of services becomes preconditions") {
  const auto imported = importedOf(component(R"(
activity calibrate() { codel<start> s() yield ether; };
activity drive() { codel<start> s() yield ether; after calibrate; };
function limit() { codel l(); before drive; };)"));
  CHECK(contains(imported.text, "  :precondition (after_calibrate (calibrate_done Yes))\n"));
  CHECK(contains(imported.text, "  :precondition (before_drive (drive_done No))\n"));
  CHECK(contains(imported.text, "  :success done (:effects (calibrate_done Yes)))"));
}

TEST_CASE("a service that interrupts itself, and one without an end, are approximated") {
  const auto imported = importedOf(component(R"(
activity a() { codel<start> s() yield pause::start, ether; interrupts a; };
activity b() { codel<start> s() yield pause::start; };)"));
  CHECK_FALSE(imported.exact);
  REQUIRE(imported.summary.size() == 4);
  CHECK(imported.summary[1] == "main.gen:3:10: approximated: a second call of `a` ends the first "
                               "one; in the program it waits for its end");
  CHECK(imported.summary[2] ==
        "main.gen:4:10: approximated: `b` never leads to `ether`; in the program it may succeed");
}

TEST_CASE("durations come from the file of leaves") {
  const auto imported =
      importedOf(component("function f() {\n codel f();\n throw e;\n};\nexception e;"),
                 R"({"leaves": {"f": {"duration": [0.5, 2], "outcomes": ["success"]}, "g": {}}})");
  CHECK(contains(imported.text, "  :time_interval [0.5,2]\n"));
  CHECK_FALSE(contains(imported.text, ":failure"));
  CHECK(contains(imported.summary[1], "no service is called `g`"));
}

TEST_CASE("a component has the services of the interfaces that it provides") {
  const auto imported = importedOf(
      Files{{"main.gen",
             "#include \"idl/more.gen\"\n" +
                 component("provides more;\nactivity go() { codel<start> s() yield ether; };")},
            {"idl/more.gen",
             "#include \"base.gen\"\ninterface more { extends base; function stop(); };\n"},
            {"idl/base.gen",
             "interface base { exception e_base; activity go(in double x) { throw e_base; }; };"}});
  CHECK(contains(imported.text,
                 "; from main.gen:4:10 activity go\n(defskill go\n  :input ($x float)\n"));
  CHECK(contains(imported.text, "  :failure e_base)"));
  CHECK(contains(imported.text, "; from idl/more.gen:2:41 function stop\n"));
  CHECK(imported.exact);
}

TEST_CASE("what cannot be read is named, and is no error") {
  const auto imported = importedOf("#include <or/pose.gen>\n" + component(R"(
activity a() { codel<start> s() yield ether; throw or_pose::e_lost; interrupts track; };)"));
  CHECK_FALSE(imported.exact);
  CHECK(contains(imported.summary[1], "main.gen:1:1: cannot read `or/pose.gen`: no such file: "));
  CHECK(contains(imported.text, "  :failure e_lost)"));
  CHECK(contains(lastLine(imported), "which differs from the components"));
}

TEST_CASE("several components have their names before those of their services") {
  const auto service = std::string("{ function look() { codel l(); }; };\n");
  const auto imported = importedOf("component a " + service + "component b " + service);
  CHECK(contains(imported.text, "(defskill a_look\n  :action (look)\n"));
  CHECK(contains(imported.text, "(defskill b_look\n"));
}

TEST_CASE("what has one name in two components is two skills") {
  const auto imported = importedOf("component a { function b_c() { codel l(); }; };\n"
                                   "component a_b { function c() { codel l(); }; };\n");
  CHECK(contains(imported.text, "(defskill a_b_c\n"));
  CHECK(contains(imported.text, "(defskill a_b_c_2\n"));
}

TEST_CASE("mistakes in components have their places") {
  CHECK(errorsIn("component a { };\ncomponent a { };") ==
        "main.gen:2:11: `a` is the name of two components\n");
  CHECK(errorsIn("interface i { };\ninterface i { };\ncomponent a { };") ==
        "main.gen:2:11: `i` is the name of two interfaces\n");
  CHECK(errorsIn("") == "main.gen:1:1: there is no `component`\n");
  CHECK(errorsIn("interface i { };") == "main.gen:1:1: there is no `component`\n");
  CHECK(errorsIn("robot r;") == "main.gen:1:1: expected `component`, `interface` or a declaration "
                                "of a type, found `robot`\n");
  CHECK(errorsIn(component("activity a( { };")) ==
        "main.gen:2:13: expected `in`, `out` or `inout`, found `{`\n");
  CHECK(errorsIn(component("activity a() { codel<start> s(); };")) ==
        "main.gen:2:32: expected `yield`, found `;`\n");
  CHECK(errorsIn(component("activity a() { codel<go> s() yield ether; };")) ==
        "main.gen:2:10: `a` has no codel for the state `start`\n");
  CHECK(errorsIn(component("activity a() { codel<start> s() yield go; codel<start> t() yield "
                           "ether; };")) == "main.gen:2:49: `start` has two codels\n"
                                            "main.gen:2:39: `go` has no codel\n");
  CHECK(errorsIn(component("activity a() { interrupts b; throw e; };\nfunction a();")) ==
        "main.gen:2:27: `b` is not a service of this component\n"
        "main.gen:2:36: `e` is not declared as an exception\n"
        "main.gen:3:10: `a` is the name of two services\n");
  CHECK(errorsIn("component c { function f(") ==
        "main.gen:1:26: expected `)`, found the end of the file\n");
  CHECK(errorsIn("#include \"main.gen\"\ncomponent c { };") ==
        "main.gen:1:1: `main.gen` includes itself\n");
  CHECK(errorsIn("component c { doc \"a\n\"; };") ==
        "main.gen:1:19: this string has no closing `\"`\n");
}

TEST_CASE("deep nesting ends with an error") {
  std::string open;
  for (int i = 0; i < 100'000; ++i) open += "struct s { ";
  CHECK(contains(errorsIn(open), "expected less deep structures"));
  std::string modules;
  for (int i = 0; i < 100'000; ++i) modules += "module m { ";
  CHECK(contains(errorsIn(modules), "expected less deep modules"));
  CHECK(contains(errorsIn("component c { ids " + std::string(1'000'000, '{')), "a type"));
}

TEST_CASE("directives that choose between texts are named, and nothing is exact then") {
  const auto chosen = importedOf("#define X 3\n#if X\n" + component("function f();") + "#else\n" +
                                 "component d {};\n#endif\n");
  CHECK_FALSE(chosen.exact);
  REQUIRE(chosen.summary.size() == 4);
  CHECK(contains(chosen.summary[0], "main.gen:1:1: approximated: `#define X 3` is ignored"));
  CHECK(contains(chosen.summary[1], "main.gen:2:1: approximated: `#if X` is ignored"));
  CHECK(contains(chosen.summary[2], "`#else` is"));
  const auto once = importedOf("#ifndef C_GEN\n#define C_GEN\n#pragma once\n" +
                               component("function f();") + "#endif\n");
  CHECK(once.summary.size() == 1);
  CHECK(once.exact);
}

} // namespace gen_import
