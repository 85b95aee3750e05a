#include "ide/verdicts/verification.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

constexpr std::string_view kStops =
    "for runs in which time goes on: `program.time_progress` is violated";

codegen::Model modelWhere(const std::string& door) {
  const auto program = test::programOfText("(defsv door :states (Open Closed) :init " + door + R"()
(defevent opens :effects (door Open))
(defskill drive :precondition (way (door Open)) :time_interval [1,2] :action (d))
(defskill m :time_interval [0,9] :body ((while (/= drive.status success) (drive))))
(defproperty soon (leadsto (running drive) (not (running drive)) :within [0,3]))
(defproperty opened (reachable (door Open)))
)");
  return codegen::generate(program).value();
}

/// The reason of the verdict, if the door is initially so.
std::string reasonOf(const std::string& door, const std::string& check) {
  const auto model = modelWhere(door);
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

TEST_CASE("where time can stop, times say that they are those of the other runs") {
  const auto timeWhere = [](const std::string& door) {
    const auto program =
        test::programOfText("(defsv door :states (Open Closed) :init " + door + R"()
(defevent opens :effects (door Open))
(defskill drive :precondition (way (door Open)) :time_interval [1,1] :action (d))
(defskill m :body ((while (/= drive.status success) (drive))))
(defproperty l (longest (running m) (ended m)))
)");
    const auto model = codegen::generate(program).value();
    return ide::verifyModel(model, {"l"}, {}).value().rows.at(0).reason;
  };
  CHECK(timeWhere("Open") == "at most 1 s");
  CHECK(timeWhere("Closed") == "at most 1 s, " + std::string(kStops));
}

TEST_CASE("a verdict on bounds that came before a limit says whether it is about all runs") {
  const auto model = modelWhere("Closed");
  const auto isOfAllRuns = [](const ide::VerdictRow& row) {
    return row.verdict == ide::Verdict::Holds && row.reason.empty() && row.check->name == "soon";
  };
  std::size_t between = 0;
  for (std::size_t jump = 1; jump < 60; ++jump) {
    std::size_t looks = 0;
    verify::Options options;
    options.reductions.erase(verify::Reduction::Slices); // they find out first that time goes on
    options.limits.seconds = 10;
    options.clock = [&] { return ++looks > jump ? 1000.0 : 0.0; };
    bool handedOver = false;
    const auto report =
        ide::verifyModel(model, {}, options, [&](std::size_t, const ide::VerdictRow& row) {
          handedOver = handedOver || isOfAllRuns(row);
        });
    REQUIRE(report.has_value());
    INFO("the limit is met at look " << jump);
    CHECK_FALSE(handedOver);
    CHECK(std::ranges::none_of(report->rows, isOfAllRuns));
    const bool isPartial = std::ranges::any_of(report->rows, [](const ide::VerdictRow& row) {
      return row.verdict == ide::Verdict::Inconclusive;
    });
    for (const auto& row : report->rows)
      between += isPartial && row.reason.starts_with("for runs in which time goes on") ? 1 : 0;
  }
  CHECK(between > 0); // the limit was reached after some verdicts on bounds
}
