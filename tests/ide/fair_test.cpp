#include "ide/verdicts/verification.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

/// The verdict on a property, with its reason.
std::string verdictOn(const std::string& pattern, bool fairRuns = true) {
  const auto program = test::programOfText("(defsv n :states (Idle Done) :init Idle)\n"
                                           "(defsv wind :states (Calm) :init Calm)\n"
                                           "(defevent gust :effects (wind Calm))\n"
                                           "(defskill drive :action (go))\n"
                                           "(defskill m :body ((drive) (set (n Done))))\n"
                                           "(defproperty p " +
                                           pattern + ")");
  const auto model = codegen::generate(program, {.fairRuns = fairRuns}).value();
  const auto report = ide::verifyModel(model, {"p"}, {});
  REQUIRE(report.has_value());
  const auto& row = report->rows.at(0);
  const auto verdict = std::string(ide::toString(row.verdict));
  return row.reason.empty() ? verdict : verdict + ", " + row.reason;
}

} // namespace

TEST_CASE("a property says which runs without end count, whatever is asked for") {
  for (const std::string property : {"(present (n Done)", "(leadsto (n Idle) (n Done)",
                                     "(infinitelyoften (n Done)", "(ltl (<> (n Done))"}) {
    INFO(property);
    const std::string fair = "holds, unless `drive` never ends";
    const std::string all = "violated, of all runs, fair or not";
    CHECK(verdictOn(property + ")") == fair);
    CHECK(verdictOn(property + ")", false) == all);
    CHECK(verdictOn(property + " :fair t)", false) == fair);
    CHECK(verdictOn(property + " :fair nil)") == all);
  }
}

TEST_CASE("of what has a time limit no verdict speaks of fair runs") {
  CHECK(verdictOn("(present (n Done) :within [0,9])", false) == "violated");
  CHECK(verdictOn("(always (n Idle))", false) == "violated");
}
