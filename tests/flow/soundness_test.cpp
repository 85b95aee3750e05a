#include "tests/flow/judgement.h"
#include "tests/support/random_program.h"

#include <catch2/catch.hpp>

#include <cstdlib>

using namespace proskill;

namespace {

/// A longer run: `PROSKILL_SEEDS=100000 test_flow`.
std::uint64_t seeds(std::uint64_t usual) {
  const char* wanted = std::getenv("PROSKILL_SEEDS");
  return wanted ? std::strtoull(wanted, nullptr, 10) : usual;
}

/// What was judged over many programs, so that a test sees that it was not idle.
struct Tally {
  std::size_t decided = 0;
  std::size_t impossible = 0;
  std::size_t certain = 0;
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
  if (judged.refuted.empty()) return;
  std::string text = test::textOf(test::minimise(std::move(program), isRefuted));
  for (const std::string& claim : test::judge(text).refuted) UNSCOPED_INFO(claim);
  FAIL("seed " << seed << "\n" << text);
}

} // namespace

TEST_CASE("The engine refutes nothing that the analysis claims about random programs") {
  Tally tally;
  std::uint64_t count = seeds(1000);
  for (std::uint64_t seed = 1; seed <= count; ++seed) expectSound(seed, {}, tally);
  INFO(tally.decided << " decided, " << tally.impossible << " claims of never, " << tally.certain
                     << " of always");
  CHECK(tally.decided > count / 2);
  CHECK(tally.impossible > count);
  CHECK(tally.certain > count / 20);
}
