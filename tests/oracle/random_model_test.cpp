#include "tests/oracle/agreement.h"
#include "tests/support/oracle/class_graph.h"
#include "tests/support/random/random_model.h"
#include "tests/support/random/seeds.h"

#include "fiacre/check/check.h"
#include "fiacre/print/print.h"

#include <catch2/catch.hpp>

namespace proskill::test::random_model_test {

namespace {

constexpr std::uint64_t kModels = 2000;
constexpr std::size_t kLimit = 2500; ///< nodes of a region graph

fiacre::Provenance watchingEverything(const fiacre::Program& program) {
  fiacre::Provenance provenance;
  for (const auto& variable : program.components[0].variables) {
    const bool scalar =
        variable.name != "letter" && variable.name != "line" && variable.name != "cells";
    if (!scalar) continue;
    std::vector<std::string> lvalues{variable.name};
    if (variable.name == "robot")
      lvalues = {"robot[left].busy", "robot[left].mood", "robot[right].busy", "robot[right].mood"};
    for (const auto& lvalue : lvalues) provenance.watched.push_back({lvalue, lvalue});
  }
  return provenance;
}

/// The oracle's answers for a correct model, with which the engine agrees in one of `each`
/// settings; nullopt if it is too large for the oracle. \param decided counts the engine's answers
std::optional<oracle::Judged> agreedOn(const fiacre::Program& program, std::uint64_t seed,
                                       std::size_t each, std::size_t& decided) {
  const auto problems = fiacre::check(program);
  INFO("seed " << seed << (problems.empty() ? "" : ": " + problems[0].message) << "\n"
               << fiacre::print(program));
  REQUIRE(problems.empty());
  oracle::Judged judged = oracle::judge(program, kLimit);
  if (!judged.complete) return std::nullopt;
  for (std::size_t i = seed % each; i < oracle::settings().size(); i += each) {
    auto wrong = oracle::disagreement(program, watchingEverything(program), judged,
                                      oracle::settings()[i], &decided);
    INFO(wrong.value_or(""));
    REQUIRE_FALSE(wrong.has_value());
  }
  return judged;
}

} // namespace

TEST_CASE("random Fiacre models are well-typed") {
  for (std::uint64_t seed = 0; seed < kModels; ++seed) {
    auto problems = fiacre::check(test::randomModel(seed));
    INFO("seed " << seed << ": " << (problems.empty() ? "" : problems[0].message));
    REQUIRE(problems.empty());
  }
}

TEST_CASE("engine and oracle agree on random Fiacre models, whatever is reduced") {
  std::size_t compared = 0;
  std::size_t decided = 0;
  std::size_t nodes = 0;
  const auto [first, end] = test::seedsOr(0, kModels);
  for (auto seed = first; seed < end; ++seed) {
    const auto judged = agreedOn(test::randomModel(seed), seed, 4, decided);
    if (!judged) continue;
    ++compared;
    nodes += judged->nodes;
  }
  WARN(compared << " models, " << nodes << " nodes, " << decided << " questions decided");
  CHECK(compared > (end - first) * 3 / 4);
  CHECK(nodes > (end - first) * 65);
}

TEST_CASE("engine and oracle agree on random models with data and priorities") {
  std::size_t compared = 0;
  std::size_t decided = 0;
  std::size_t withPriorities = 0;
  const auto [first, end] = test::seedsOr(0, 1800);
  for (auto seed = first; seed < end; ++seed) {
    const fiacre::Program program = test::randomModelWithData(seed);
    if (!agreedOn(program, seed, 5, decided)) continue;
    ++compared;
    withPriorities += program.components[0].priorities.size();
  }
  WARN(compared << " models, " << withPriorities << " with priorities between ports, " << decided
                << " questions decided");
  CHECK(compared > (end - first) / 4);
  CHECK(withPriorities > (end - first) / 180);
}

TEST_CASE("engine and oracle agree on random models with observers") {
  std::size_t compared = 0;
  std::size_t decided = 0;
  std::size_t seen = 0;
  const auto [first, end] = test::seedsOr(0, 1000);
  for (auto seed = first; seed < end; ++seed) {
    const fiacre::Program program = test::randomModelWithObserver(seed);
    const auto judged = agreedOn(program, seed, 5, decided);
    if (!judged) continue;
    ++compared;
    for (std::size_t i = judged->truths.size() - 2; i < judged->truths.size(); ++i)
      seen += judged->truths[i] == false ? 1 : 0;
  }
  WARN(compared << " models, in which " << seen << " probes saw something, " << decided
                << " questions decided");
  CHECK(compared > (end - first) / 3);
  CHECK(seen > compared / 4);
}

TEST_CASE("the engine counts state classes as the textbook does") {
  std::size_t compared = 0;
  const auto [first, end] = test::seedsOr(0, kModels);
  for (auto seed = first; seed < end; ++seed) {
    fiacre::Program program = test::randomModel(seed);
    oracle::Interpreter model(program);
    auto expected = oracle::countClasses(model, kLimit);
    if (!expected.complete) continue;
    ++compared;
    const auto jobs = static_cast<unsigned>(1 + seed % 3);
    auto counted = verify::countClasses(
        program, {.jobs = jobs, .classesBeforeThreads = 0, .nodesBeforeThreads = 0});
    INFO("seed " << seed << ", " << jobs << " threads\n" << fiacre::print(program));
    REQUIRE(counted.has_value());
    CHECK(counted->classes == expected.classes);
    CHECK(counted->markings == expected.markings);
    CHECK(counted->transitions == expected.transitions);
    REQUIRE(counted->domains == expected.domains);
  }
  CHECK(compared > (end - first) * 3 / 4);
}

} // namespace proskill::test::random_model_test
