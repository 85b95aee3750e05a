#include "ide/verdicts/verification.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

constexpr std::string_view kStops =
    "of runs in which time goes on: `program.time_progress` is violated";

/// What the verdict rests on, where the door is so at the start.
std::string reasonOf(const std::string& door, const std::string& check) {
  const auto program = test::programOfText("(defsv door :states (Open Closed) :init " + door + R"()
(defevent opens :effects (door Open))
(defskill drive :precondition (way (door Open)) :time_interval [1,2] :action (d))
(defskill m :time_interval [0,9] :body ((while (/= drive.status success) (drive))))
(defproperty soon (leadsto (running drive) (not (running drive)) :within [0,3]))
(defproperty opened (reachable (door Open)))
)");
  const auto model = codegen::generate(program).value();
  const auto report = ide::verifyModel(model, {check}, {});
  REQUIRE(report.has_value());
  REQUIRE(report->rows.size() == 1);
  REQUIRE(report->rows[0].verdict != ide::Verdict::Inconclusive);
  return report->rows[0].reason;
}

} // namespace

TEST_CASE("where time can stop, verdicts on bounds say that they are about the other runs") {
  CHECK(reasonOf("Closed", "soon") == kStops);
  CHECK(reasonOf("Closed", "opened").empty());
  CHECK(reasonOf("Open", "soon").empty());
}
