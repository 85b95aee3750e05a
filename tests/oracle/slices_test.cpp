#include "fiacre/syntax/parse.h"
#include "tests/oracle/agreement.h"
#include "tests/support/random/random_source.h"
#include "tests/support/random/seeds.h"

#include "fiacre/check/check.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace proskill::test::slices_test {

namespace {

constexpr std::size_t kLimit = 6000; ///< nodes of a region graph
constexpr std::size_t kFlags = 3;

/// Processes that come to an end, and on their way set, clear and await flags of all. The questions
/// are about what each has done, never about where it is: so much of each process is irrelevant.
class RandomCourses {
public:
  explicit RandomCourses(std::uint64_t seed) : random(seed), count(random.chance(40) ? 3 : 2) {}

  std::string text() {
    std::string made;
    for (std::size_t i = 0; i < count; ++i) made += process(i);
    made += "process Other is states a, b from a wait [1,1]; to b from b wait [1,2]; to a\n";
    std::vector<std::string> variables;
    std::vector<std::string> instances;
    for (std::size_t i = 0; i < kFlags; ++i)
      variables.push_back(fmt::format("c{}: bool := {}", i, random.chance(30)));
    for (std::size_t i = 0; i < count; ++i) {
      variables.push_back(fmt::format("v{}: 0..2 := 0", i));
      instances.push_back(fmt::format("P{0}(&c0, &c1, &c2, &v{0})", i));
    }
    made += fmt::format("component main is var {} par * in {} || Other end\nmain\n",
                        fmt::join(variables, ", "), fmt::join(instances, " || "));
    for (std::size_t i = 0; i < count; ++i)
      made += fmt::format("property p{0} is absent main/value v{0} = {1} assert p{0}\n", i,
                          random.below(2) + 1);
    for (std::size_t i = 0; i < count; ++i)
      made += fmt::format("property q{0} is absent ((main/value v{0} = {1}) and (main/value v{2} = "
                          "{3})) assert q{0}\n",
                          i, random.below(2) + 1, (i + 1) % count, random.below(3));
    return made;
  }

private:
  std::string process(std::size_t i) {
    std::string made = fmt::format(
        "process P{} (&c0, &c1, &c2: bool, &v: 0..2) is states s0, s1, s2, s3, over\n", i);
    for (std::size_t at = 0; at < 4; ++at) {
      std::vector<std::string> steps{step(i, at)};
      if (random.chance(25)) steps.push_back(step(i, at));
      if (random.chance(35))
        steps.push_back(fmt::format("wait [0,0]; on {}; to over", condition()));
      made += fmt::format("from s{} select {} end\n", at, fmt::join(steps, " [] "));
    }
    return made;
  }

  std::string step(std::size_t i, std::size_t at) {
    static const std::vector<std::string> waits{"[1,1]", "[2,2]",   "[0,1]",
                                                "[3,3]", "[1,...[", "[0,...["};
    std::string made = "wait " + (random.chance(35) ? "[0,0]" : random.pick(waits)) + "; ";
    if (random.chance(50)) made += fmt::format("on {}; ", random.chance(60) ? own(i) : condition());
    if (random.chance(20))
      return made + (random.chance(40) ? effects(i) : "") +
             fmt::format("if {} then {}{} else {}{} end", condition(), effects(i), end(at),
                         effects(i), end(at));
    return made + effects(i) + end(at);
  }

  std::string own(std::size_t i) {
    return fmt::format("{}c{}", random.chance(30) ? "not " : "", i);
  }

  std::string condition() {
    const auto first = own(random.below(kFlags));
    if (random.chance(75)) return first;
    return fmt::format("({} {} {})", first, random.chance(50) ? "and" : "or",
                       own(random.below(kFlags)));
  }

  std::string effects(std::size_t i) {
    std::string made;
    if (random.chance(60))
      made += fmt::format("c{} := {}; ", random.chance(80) ? i : random.below(kFlags),
                          random.chance(50));
    if (random.chance(30)) made += fmt::format("v := {}; ", random.below(3));
    return made;
  }

  std::string end(std::size_t at) {
    if (random.chance(5)) return fmt::format("to s{}", random.below(at + 1));
    return at < 3 ? fmt::format("to s{}", at + 1) : "to over";
  }

  RandomSource random;
  std::size_t count;
};

fiacre::Program modelOf(const std::string& text) {
  auto parsed = fiacre::parse(text);
  for (const auto& problem : parsed.problems) FAIL(problem.message << "\n" << text);
  for (const auto& problem : fiacre::check(parsed.program)) FAIL(problem.message << "\n" << text);
  return std::move(parsed.program);
}

/// The model with one of its questions.
fiacre::Program with(fiacre::Program program, std::size_t property) {
  program.properties = {program.properties[property]};
  return program;
}

/// Settings in which parts are asked before the whole.
std::vector<std::pair<std::string, verify::Options>> partsFirst() {
  using verify::Reduction;
  std::vector<std::pair<std::string, verify::Options>> made{
      {"slices", {}}, {"refinement", {}}, {"refinement alone", {.reductions = {}}}};
  for (auto& [name, options] : made) options.classesBeforeSlices = 0;
  made[0].second.reductions.erase(Reduction::Refinement);
  made[1].second.reductions.erase(Reduction::Slices);
  made[2].second.reductions = {Reduction::Refinement, Reduction::Extrapolation};
  return made;
}

} // namespace

TEST_CASE("engine and oracle agree on questions to parts of random models, alone and together") {
  std::size_t judgedModels = 0;
  std::size_t reached = 0;
  std::map<std::string, std::uint64_t> answers; // of parts, by setting
  const auto [first, end] = seedsOr(0, 2500);
  for (auto seed = first; seed < end; ++seed) {
    const auto text = RandomCourses(seed).text();
    INFO("seed " << seed << "\n" << text);
    const auto program = modelOf(text);
    const auto judged = oracle::judge(program, kLimit);
    if (!judged.complete) continue;
    ++judgedModels;
    for (const auto& setting : partsFirst()) { // questions that share slices
      std::uint64_t ofParts = 0;
      const auto wrong = oracle::disagreement(program, {}, judged, setting, nullptr, &ofParts);
      INFO(wrong.value_or(""));
      REQUIRE_FALSE(wrong);
      answers[setting.first + ", together"] += ofParts;
    }
    for (std::size_t i = 0; i < program.properties.size(); ++i) {
      const auto asked = with(program, i);
      reached += judged.truths[i] == false ? 1 : 0;
      for (const auto& setting : partsFirst()) {
        const oracle::Judged one{{judged.truths[i]}, judged.nodes, true, judged.model};
        std::uint64_t ofParts = 0;
        const auto wrong = oracle::disagreement(asked, {}, one, setting, nullptr, &ofParts);
        INFO(wrong.value_or(""));
        REQUIRE_FALSE(wrong);
        answers[setting.first] += ofParts;
      }
    }
  }
  INFO(judgedModels << " models, " << reached << " runs found");
  CHECK(judgedModels > 0);
  CHECK(reached > 10);
  for (const auto& [name, count] : answers) {
    INFO(name);
    CHECK(count > 10);
  }
}

} // namespace proskill::test::slices_test
