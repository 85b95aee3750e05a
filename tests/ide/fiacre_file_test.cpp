#include "ide/snapshot/fiacre_file.h"

#include "ide/verdicts/verification.h"
#include "syntax/diagnostics/codes.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

/// The text and the message of each diagnostic.
std::string found(const std::string& text) {
  std::string all;
  for (const auto& each : ide::readFiacre("m.fcr", text).diagnostics)
    all += "`" + text.substr(each.location.range.begin, each.location.range.length()) +
           "`: " + each.message + "\n";
  return all;
}

std::string told(const std::vector<verify::Change>& changes) {
  std::string all;
  for (const auto& each : changes)
    all += each.variable + ": " + each.before + " to " + each.after + ", ";
  return all;
}

} // namespace

TEST_CASE("the codes about Fiacre are raised by their examples") {
  for (auto code :
       {syntax::Code::FiacreText, syntax::Code::FiacreModel, syntax::Code::FiacreLonePort}) {
    const auto read = ide::readFiacre("m.fcr", std::string(syntax::info(code).example));
    INFO(syntax::info(code).id);
    REQUIRE_FALSE(read.diagnostics.empty());
    CHECK(read.diagnostics[0].code == code);
  }
}

TEST_CASE("a mistake in Fiacre is told at the name that it is about") {
  CHECK(found("process P is\nstates a\nfrom a x := 1; to a\n"
              "component m is par * in P end\nm") ==
        "`x`: process P, state a: `x` is not a variable and cannot be assigned to\n");
  CHECK(found("process P is\nstates a\nfrom a to b\ncomponent m is par * in P end\nm") ==
        "`b`: process P, state a: the state `b` is not declared\n");
}

TEST_CASE("a port that nobody else has is told where it is declared, and the model is verified") {
  const std::string text = "process P [go: sync] is\nstates a, b\nfrom a go; to a\n"
                           "process Q is\nstates a\n"
                           "component other [go: sync] is par * in P[go] || P[go] end\n"
                           "component m is port go: sync par * in P[go] || Q end\nm\n"
                           "property alive is deadlockfree\nassert alive\n";
  const auto read = ide::readFiacre("m.fcr", text);
  REQUIRE(read.diagnostics.size() == 1);
  const auto& warning = read.diagnostics[0];
  CHECK(warning.message == "only P has the port `go`: it is taken alone, whenever its process can");
  CHECK(warning.severity == syntax::Severity::Warning);
  CHECK(warning.location.range.begin == text.rfind("go: sync par"));
  REQUIRE_FALSE(read.hasErrors());
  const auto report = ide::verifyModel(read.model, {}, {});
  REQUIRE(report.has_value());
  CHECK(report->rows[0].verdict == ide::Verdict::Holds);
}

TEST_CASE("of several instances of a process each has its name in a trace") {
  const auto read =
      ide::readFiacre("m.fcr", "process P [p: sync] is\nstates a, b\nfrom a p; to b\n"
                               "component m is port p: sync par * in P[p] || P[p] end\nm\n"
                               "property never is absent m/2/state b\nassert never\n");
  REQUIRE(read.diagnostics.empty());
  const auto report = ide::verifyModel(read.model, {}, {});
  REQUIRE(report.has_value());
  REQUIRE(report->rows[0].trace.has_value());
  const auto& trace = *report->rows[0].trace;
  CHECK(told(trace.initial) == "P_1:  to a, P_2:  to a, ");
  REQUIRE(trace.steps.size() == 1);
  CHECK(trace.steps[0].actor == "P_1, P_2");
  CHECK(told(trace.steps[0].changes) == "P_1: a to b, P_2: a to b, ");
}

TEST_CASE("a model by hand is verified, with a trace at its lines") {
  const std::string text = "process P is\nstates a, b\nvar x: 0..3 := 0\n"
                           "from a wait [1,2]; x := x + 1; if x = 3 then to b else to a end\n"
                           "component m is par * in P end\nm\n"
                           "property never is absent m/1/state b\nassert never\n";
  const auto read = ide::readFiacre("m.fcr", text);
  REQUIRE(read.diagnostics.empty());
  const auto report = ide::verifyModel(read.model, {}, {});
  REQUIRE(report.has_value());
  REQUIRE(report->rows.size() == 2);
  CHECK(report->rows[1].check->name == "no_runtime_error");
  CHECK(report->rows[1].verdict == ide::Verdict::Holds);
  CHECK(report->rows[0].verdict == ide::Verdict::Violated);
  REQUIRE(report->rows[0].trace.has_value());
  const auto& steps = report->rows[0].trace->steps;
  REQUIRE(steps.size() == 3);
  CHECK(steps[2].description == "to b");
  CHECK(steps[2].actor == "P_1");
  CHECK(told(steps[2].changes) == "P_1: a to b, P_1.x: 2 to 3, ");
  CHECK(text.substr(steps[2].location->range.begin, steps[2].location->range.length()) == "to b");
  CHECK(steps[2].earliest.seconds == syntax::Rational{3, 1});
  CHECK(steps[2].latest->seconds == syntax::Rational{6, 1});
}

TEST_CASE("an error at run time is a verdict, and its trace ends where it happens") {
  const std::string text = "process P is\nstates a\nvar x: 0..1 := 0\n"
                           "from a wait [1,2]; x := x + 1; to a\n"
                           "component m is par * in P end\nm\n";
  const auto read = ide::readFiacre("m.fcr", text);
  const auto report = ide::verifyModel(read.model, {}, {});
  REQUIRE(report.has_value());
  REQUIRE(report->rows.size() == 1);
  CHECK(report->rows[0].verdict == ide::Verdict::Violated);
  const auto& steps = report->rows[0].trace->steps;
  REQUIRE(steps.size() == 2);
  CHECK(steps[1].description == "x := x + 1: `P_1.x` would get the value 2, outside of 0..1");
  CHECK(text.substr(steps[1].location->range.begin, steps[1].location->range.length()) ==
        "x := x + 1");
}
