#include "ide/verdicts/verification.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;

namespace {

/// Its properties take a search for states, and one each with a monitor.
constexpr const char* kSeveralSearches = R"((defsv door :states (Open Closed) :init Open)
(defskill go :time_interval [1,2] :action (go) :success there (:effects (door Closed)))
(defskill mission :body ((go)))
(defproperty closes (leadsto (door Open) (door Closed)))
(defproperty again (ltl (G (F (running mission)))))
)";

} // namespace

TEST_CASE("progress counts all properties, whichever are searched for") {
  const auto model = codegen::generate(test::programOfText(kSeveralSearches));
  REQUIRE(model.has_value());
  verify::Options options;
  double now = 0;
  options.clock = [&] { return ++now; };
  std::vector<verify::Progress> told;
  options.progress = [&](const verify::Progress& progress) { told.push_back(progress); };
  const auto report = ide::verifyModel(*model, {}, options);
  REQUIRE(report.has_value());
  REQUIRE(told.size() > 1);
  for (const auto& progress : told) CHECK(progress.questions == report->rows.size());
  CHECK(std::ranges::is_sorted(told, {}, &verify::Progress::decided));
  CHECK(told.back().decided + 1 == report->rows.size());
}
