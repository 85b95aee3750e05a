#include "fiacre/check/check.h"
#include "fiacre/syntax/parse.h"
#include "tests/oracle/agreement.h"
#include "tests/support/random/random_source.h"
#include "tests/support/random/seeds.h"
#include "verify/compile/compile.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace proskill::test::counting_test {

namespace {

constexpr std::size_t kLimit = 5000; ///< nodes of a region graph

/// Processes that change a number on their ways. Mostly each takes back what it has added; guards
/// that keep the number within its range are sometimes missing.
class RandomCounting {
public:
  explicit RandomCounting(std::uint64_t seed)
      : random(seed), count(random.below(2) + 2), most(random.below(3) + 1) {}

  std::string text() {
    std::string made;
    std::vector<std::string> instances;
    for (std::size_t i = 0; i < count; ++i) {
      made += process(i);
      instances.push_back(fmt::format("P{}(&n, &b)", i));
    }
    return made + fmt::format("component main is var n: 0..{} := {}, b: bool := false\n"
                              "par * in {} end\nmain\n",
                              most, random.chance(75) ? 0 : 1, fmt::join(instances, " || "));
  }

private:
  std::string process(std::size_t i) {
    const auto adds = random.chance(80) ? 1 : 2;
    const auto less = random.chance(90) ? adds : random.below(2) + 1;
    const auto* states = random.chance(30) ? "d, a, c" : "a, c, d"; // may begin by giving back
    std::string made =
        fmt::format("process P{} (&n: 0..{}, &b: bool) is states {}\n", i, most, states);
    made += fmt::format("from a {}{}\n", wait(), taking(adds));
    made += fmt::format("from c select {}{}to {}", wait(), noise(), random.chance(70) ? "d" : "c");
    if (random.chance(40)) made += fmt::format(" [] {}{}to a", wait(), giving(less));
    if (random.chance(10)) made += fmt::format(" [] {}to a", wait());
    return made + fmt::format(" end\nfrom d {}{}to a\n", wait(), giving(less));
  }

  std::string wait() {
    return random.pick(
        std::vector<std::string>{"wait [0,0]; ", "wait [1,1]; ", "wait [0,2]; ", "wait [1,...[; "});
  }

  std::string noise() { return random.chance(40) ? "b := not b; " : ""; }

  std::string taking(std::size_t adds) {
    const auto room = fmt::format("n < {}", most + (random.chance(20) ? 1 : 0) + 1 - adds);
    const auto add = fmt::format("n := n + {}; ", adds);
    if (random.chance(15)) return add + "to c";
    if (random.chance(60)) return fmt::format("on {}{}; {}{}to c", room, alsoOn(), noise(), add);
    return fmt::format("if {}{} then {}to c else to {} end", room, alsoOn(), add,
                       random.chance(85) ? "a" : "d");
  }

  std::string alsoOn() { return random.chance(30) ? " and b" : ""; }

  std::string giving(std::size_t less) {
    if (random.chance(10)) return fmt::format("if n > {} then n := n - {} end; ", less, less);
    return fmt::format("n := n - {}; ", less);
  }

  RandomSource random;
  std::size_t count;
  std::size_t most;
};

fiacre::Program modelOf(const std::string& text) {
  auto parsed = fiacre::parse(text);
  for (const auto& problem : parsed.problems) FAIL(problem.message << "\n" << text);
  for (const auto& problem : fiacre::check(parsed.program)) FAIL(problem.message << "\n" << text);
  return std::move(parsed.program);
}

/// Whether some step of the compiled model may fail.
bool mayFail(const fiacre::Program& program) {
  const auto compiled = verify::compile(program, {}, {});
  REQUIRE(compiled);
  return std::ranges::any_of(compiled->system.paths, &verify::Path::mayFail);
}

/// Whether the oracle meets an error, if only of a step that time never allows; nothing if the
/// model is too large for it.
std::optional<bool> fails(const fiacre::Program& program) {
  try {
    const auto judged = oracle::judge(program, kLimit);
    if (!judged.complete) return std::nullopt;
    return false;
  } catch (const oracle::ModelError&) {
    return true;
  }
}

} // namespace

TEST_CASE("steps that fail in a random model are known as such, whatever a number counts") {
  std::size_t failing = 0;
  std::size_t excluded = 0;
  std::size_t vainly = 0;
  const auto [first, end] = seedsOr(0, 3000);
  for (auto seed = first; seed < end; ++seed) {
    const auto text = RandomCounting(seed).text();
    INFO("seed " << seed << "\n" << text);
    const auto program = modelOf(text);
    const auto isFailing = fails(program);
    if (!isFailing) continue;
    const bool maybe = mayFail(program);
    const bool isRefused = !verify::verify(program, {}, {});
    if (*isFailing) REQUIRE(maybe);
    if (isRefused) REQUIRE(*isFailing);
    failing += isRefused ? 1 : 0;
    excluded += maybe ? 0 : 1;
    vainly += maybe && !*isFailing ? 1 : 0;
  }
  INFO(failing << " models fail, " << excluded << " are known not to, " << vainly << " do not");
  CHECK(failing > 10);
  CHECK(excluded > 10);
}

} // namespace proskill::test::counting_test
