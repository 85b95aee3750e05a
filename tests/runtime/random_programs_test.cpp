#include "tests/runtime/run_of.h"
#include "tests/support/random/random_program.h"
#include "verify/trace/simulator.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace proskill;
using test::runOf;

namespace {

/// Whether the run is a run of its own transition system, according to the verifier's simulator,
/// which does not use the machine's dates and sets. \return an error; empty on success
std::string judge(const runtime::Executable& executable, const test::Ran& ran) {
  const verify::Simulator simulator(executable.system, executable.unit);
  auto now = simulator.start();
  verify::StepLog log;
  for (std::size_t i = 0; i < ran.steps.size(); ++i) {
    const auto& [step, date, actor, description] = ran.steps[i];
    const auto name = fmt::format("step {}, {} {} at {}", i, actor, description, date);
    if (!simulator.mayWait(now, date)) return name + ": something has to come before";
    if (!simulator.isRipe(now, step, date)) return name + ": it is not possible now";
    auto next = simulator.take(now, step, date, log);
    if (!next) return name + ": it fails";
    now = std::move(*next);
  }
  return "";
}

} // namespace

TEST_CASE("every run of a random program is a run of its transition system") {
  std::size_t steps = 0;
  std::size_t missions = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto text =
        test::textOf(test::randomProgram(seed, test::varied(seed, {.properties = 0})));
    const auto executable = test::executableOf(text);
    const auto ran = runOf(*executable, seed, "", "", 30);
    INFO("seed " << seed << "\n" << text << ran.text());
    CHECK(ran.result.end != runtime::End::Failed);
    if (ran.steps.size() > 2000) continue; // probably time has stopped
    CHECK(judge(*executable, ran) == "");
    steps += ran.steps.size();
    missions += ran.result.end == runtime::End::Mission ? 1 : 0;
  }
  CHECK(steps > 3000);
  CHECK(missions > 30);
}

TEST_CASE("the same seed gives the same run, another one another") {
  const auto executable = test::executableOf(R"(
    (defskill fly :time_interval [2,5] :success (there here) :failure lost)
    (defskill mission :body ((fly) (fly))))");
  CHECK(runOf(*executable, 5).text() == runOf(*executable, 5).text());
  std::set<std::string> different;
  for (std::uint64_t seed = 0; seed < 10; ++seed) different.insert(runOf(*executable, seed).text());
  CHECK(different.size() > 1);
}
