#include "syntax/diagnostics/diagnostic.h"
#include "tests/flow/judgement.h"
#include "tests/support/random/random_program.h"
#include "tests/support/random/seeds.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <map>

using namespace proskill;

namespace {

const test::ProgramSize kUsual{.labels = 40};
/// More skills with more shared variables and shorter bodies.
const test::ProgramSize kMany{.resources = 2,
                              .basicSkills = 3,
                              .composites = 3,
                              .statements = 2,
                              .branches = 2,
                              .properties = 0,
                              .environment = 30,
                              .labels = 40};

/// Conditions and effects that read inputs.
const test::ProgramSize kInputs{.library = 20, .inputs = 60, .labels = 40};

/// Findings of the flow analysis, except on resource order, rates, style and constants.
bool makesClaim(std::string_view id) {
  return id >= "PS0500" && id < "PS1100" && id != "PS0903" && id != "PS1006" && id != "PS0616";
}

/// Totals over many programs, so that a test sees that something was checked.
struct Tally {
  std::size_t decided = 0;
  std::size_t impossible = 0;
  std::size_t certain = 0;
  std::map<std::string, std::size_t> codes;
};

bool isRefuted(const std::vector<test::Form>& program) {
  return !test::judge(test::textOf(program)).refuted.empty();
}

void expectSound(std::uint64_t seed, const test::ProgramSize& size, Tally& tally) {
  auto program = test::randomProgram(seed, size);
  test::Judged judged = test::judge(test::textOf(program));
  tally.decided += judged.decided;
  tally.impossible += judged.impossible;
  tally.certain += judged.certain;
  for (const auto& [code, count] : judged.codes) tally.codes[code] += count;
  if (judged.refuted.empty()) return;
  std::string text = test::textOf(test::minimise(std::move(program), isRefuted));
  for (const std::string& claim : test::judge(text).refuted) UNSCOPED_INFO(claim);
  FAIL("seed " << seed << "\n" << text);
}

} // namespace

TEST_CASE("The engine refutes nothing that the analysis claims about random programs") {
  Tally tally;
  const auto seeds = test::seedsOr(2001, 1100);
  const std::uint64_t count = seeds.end - seeds.first;
  for (auto seed = seeds.first; seed < seeds.end; ++seed)
    expectSound(seed, seed % 2 == 1 ? kUsual : kMany, tally);
  std::string often;
  for (const auto& [code, times] : tally.codes) often += fmt::format(" {}: {}", code, times);
  INFO(tally.decided << " decided, " << tally.impossible << " claims of never, " << tally.certain
                     << " of always\n"
                     << often);
  if (std::getenv("PROSKILL_SEEDS")) WARN(tally.decided << " decided," << often);
  CHECK(tally.decided > count / 2);
  CHECK(tally.impossible > count);
  CHECK(tally.certain > count / 20);
  if (count < 1100) return;
  for (const syntax::CodeInfo& info : syntax::allCodes()) {
    INFO(info.id << " is never said of these programs");
    CHECK((!makesClaim(info.id) || tally.codes.contains(std::string(info.id))));
  }
}

TEST_CASE("The engine refutes nothing that the analysis claims about inputs") {
  Tally tally;
  const auto seeds = test::seedsOr(4'000'001, 400);
  for (auto seed = seeds.first; seed < seeds.end; ++seed) expectSound(seed, kInputs, tally);
  if (std::getenv("PROSKILL_SEEDS")) WARN(tally.decided << " decided");
  CHECK(tally.impossible > seeds.end - seeds.first);
}

TEST_CASE("A claim about a statement after a timeout is judged by it, not by the wait around it") {
  const auto judged = test::judge("(defskill m :body ((^ true :timeout 3 (race ((label again) "
                                  "(^ true) (goto again))))))");
  CHECK(judged.codes.contains("PS1008"));
  CHECK(judged.refuted.empty());
}
