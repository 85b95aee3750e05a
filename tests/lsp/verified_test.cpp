#include "lsp/verification/verified.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

namespace proskill::test::verified_test {

using enum ide::Verdict;
using Program = std::shared_ptr<const ide::AnalysedProgram>;

namespace {

/// A verdict on the door, with a trace if it is violated.
lsp::Verified verified(const Program& program, ide::Verdict verdict, bool pending = false) {
  auto verdicts = std::make_shared<ide::ProgramVerdicts>();
  verdicts->program = program;
  ide::PropertyVerdict property;
  property.name = property.subject = "door";
  property.verdict = verdict;
  property.pending = pending;
  verdicts->properties = {property};
  lsp::Verified result{verdicts, "", {}};
  if (verdict == Violated) result.traces["door"] = std::make_shared<const std::string>("{}");
  return result;
}

} // namespace

TEST_CASE("a verdict stays decided when another verification of the same text does not decide it") {
  const Program program = std::make_shared<const ide::AnalysedProgram>(
      programOfText("(defsv door :states (Open Shut) :init Open)\n"), analysis::flow::Settings());
  const auto merged = [&](const lsp::Verified& older, const lsp::Verified& newer) {
    auto both = lsp::merged(older, newer);
    REQUIRE(both.verdicts->properties.size() == 1);
    return std::tuple(both.verdicts->properties[0].verdict, both.verdicts->properties[0].pending,
                      both.traces.contains("door"));
  };
  const auto violated = verified(program, Violated);
  const auto open = verified(program, Inconclusive);
  const auto pending = verified(program, Inconclusive, true);
  CHECK(merged(violated, open) == std::tuple(Violated, false, true));
  CHECK(merged(violated, pending) == std::tuple(Violated, false, true));
  CHECK(merged(open, violated) == std::tuple(Violated, false, true));
  CHECK(merged(pending, open) == std::tuple(Inconclusive, false, false));
  CHECK(merged(open, pending) == std::tuple(Inconclusive, false, false));
  CHECK(merged(violated, verified(program, Holds)) == std::tuple(Holds, false, false));
}

} // namespace proskill::test::verified_test
