#include "ide/verdicts/verification.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

/// A mission that may end at once, and then stays so while events go on.
const std::string kCart = R"((defsv battery :states (Good Low Critical) :init Good)
(defevent low :every [20,...[ :effects (battery Low))
(defevent critical :every [10,...[ :effects (battery Critical))
(defskill go :time_interval [1,2] :action (go))
(defskill mission :interrupt () :body ((go)))
(defskill watch :monitor t :body ((while true (^ (battery Critical)) (mission.interrupt) (go))))
(defproperty charged (leadsto (battery Critical) (battery Good)))
)";

/// A mission that ends, after which nothing happens.
const std::string kShort = R"((defskill go :time_interval [1,2] :action (go))
(defskill mission :body ((go)))
(defproperty again (ltl (G (F (running mission)))))
)";

/// Each trace of a program.
std::vector<ide::Trace> tracesOf(const std::string& text) {
  const auto model = codegen::generate(test::programOfText(text));
  REQUIRE(model.has_value());
  const auto report = ide::verifyModel(*model, {}, {});
  REQUIRE(report.has_value());
  std::vector<ide::Trace> all;
  for (const auto& row : report->rows)
    if (row.trace) all.push_back(*row.trace);
  return all;
}

void checkSteps(const ide::Trace& trace) {
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    const auto& step = trace.steps[i];
    INFO(trace.summary << " step " << i + 1);
    CHECK_FALSE(step.description.empty());
    for (auto cause : step.causes) CHECK(cause < i);
  }
  if (trace.loop) CHECK(*trace.loop < trace.steps.size());
}

} // namespace

TEST_CASE("a trace has no steps in which a skill that has ended stays so") {
  const auto all = tracesOf(kCart);
  REQUIRE(all.size() > 5);
  for (const auto& trace : all) checkSteps(trace);
  const auto& charged = all.back();
  REQUIRE(charged.loop);
  CHECK(charged.summary.starts_with("Steps " + std::to_string(*charged.loop + 1) + " to " +
                                    std::to_string(charged.steps.size())));
  CHECK(charged.steps.back().why == "at least 20 s after step 5");
  CHECK(charged.steps[4].description == "occurs");

  const auto again = tracesOf(kShort).back();
  checkSteps(again);
  CHECK_FALSE(again.loop);
  CHECK(again.summary.starts_with("After step " + std::to_string(again.steps.size())));
}
