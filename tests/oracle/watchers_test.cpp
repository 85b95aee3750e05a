#include "tests/oracle/agreement.h"
#include "tests/support/models.h"
#include "tests/support/random/random_source.h"
#include "tests/support/random/seeds.h"

#include "fiacre/print/print.h"

#include <catch2/catch.hpp>

namespace proskill::test::watchers_test {

namespace {

using fiacre::Expr;
using fiacre::Op;
using fiacre::Statement;

/// Processes that wait for inputs which an environment sets at any time, most of them for one of
/// their own. Others may observe what they do there, or not.
class Watchers {
public:
  explicit Watchers(std::uint64_t seed) : random(seed) {}

  Model build() {
    model.variable("x", range(0, 2), number(0));
    for (std::size_t i = 0; i < kProcesses; ++i) addInput(i);
    for (std::size_t i = 0; i < kProcesses; ++i) addProcess(i);
    for (std::uint32_t i = 0; i < kProcesses; ++i)
      for (const auto& location : kLocations)
        if (random.chance(70)) model.ask(absentState(kProcesses + 1 + i, location));
    for (std::int64_t value = 0; value <= 2; ++value)
      model.ask(absentValue(equals(name("x"), number(value))));
    model.ask(plain(fiacre::PatternKind::DeadlockFree));
    model.ask(plain(fiacre::PatternKind::Progress));
    return std::move(model);
  }

private:
  static constexpr std::uint32_t kProcesses = 2;
  static inline const std::vector<std::string> kLocations{"a", "b", "c", "d"};

  static std::string input(std::size_t i) { return "input" + std::to_string(i); }

  /// Sometimes it starts with a value that is never set.
  void addInput(std::size_t i) {
    const std::int64_t values = random.between(2, 3);
    model.variable(input(i), range(0, 3), number(random.chance(20) ? 3 : 0));
    std::vector<Statement> all;
    for (std::int64_t value = 0; value < values; ++value)
      all.push_back(sequence({assign(name(input(i)), number(value)), to("a")}));
    model.add(process("sets_" + input(i), {"a"}, {from("a", {select(all)})}));
  }

  Expr condition(std::size_t own) {
    if (random.chance(15)) return truth(true);
    if (random.chance(10)) return equals(name("x"), number(random.between(0, 2)));
    const auto which = random.chance(80) ? own : random.below(kProcesses);
    const auto value = number(random.between(0, 3));
    return random.chance(50) ? equals(name(input(which)), value)
                             : binary(Op::Less, name(input(which)), value);
  }

  Statement step(std::size_t own) {
    std::vector<Statement> all;
    if (random.chance(75)) {
      all.push_back(random.chance(90) ? now() : always());
      all.push_back(on(condition(own)));
    } else {
      const auto low = random.between(0, 2);
      all.push_back(wait(low, low + random.between(0, 2)));
    }
    if (random.chance(25)) all.push_back(assign(name("x"), number(random.between(0, 2))));
    all.push_back(to(random.pick(kLocations)));
    return sequence(std::move(all));
  }

  void addProcess(std::size_t i) {
    std::vector<fiacre::From> places;
    for (const auto& location : kLocations) {
      if (random.chance(10)) continue; // it stays there
      std::vector<Statement> steps{step(i)};
      if (random.chance(20)) steps.push_back(step(i));
      if (steps.size() == 1)
        places.push_back(from(location, {steps[0]}));
      else
        places.push_back(from(location, {select(steps)}));
    }
    model.add(process("p" + std::to_string(i), kLocations, std::move(places)));
  }

  RandomSource random;
  Model model;
};

} // namespace

TEST_CASE("engine and oracle agree on random watchers of inputs, with and without private moves") {
  const Seeds seeds = seedsOr(0, 1200);
  std::size_t compared = 0;
  std::size_t reduced = 0;
  for (std::uint64_t seed = seeds.first; seed < seeds.end; ++seed) {
    const Model model = Watchers(seed).build();
    const auto judged = oracle::judge(model.program(), 4000);
    if (!judged.complete) continue;
    ++compared;
    INFO("seed " << seed << "\n" << fiacre::print(model.program()));
    for (const auto& setting : oracle::settings()) {
      const bool isNear = setting.first.find("private") != std::string::npos;
      if (!isNear && setting.first != "all reductions") continue;
      const auto wrong = oracle::disagreement(model.program(), {}, judged, setting);
      INFO(wrong.value_or(""));
      REQUIRE_FALSE(wrong.has_value());
    }
    verify::Options without;
    without.reductions.erase(verify::Reduction::PrivateMoves);
    reduced += model.answers().exploration.markings < model.answers(without).exploration.markings;
  }
  INFO(compared << " models, " << reduced << " of them reduced");
  CHECK(compared > (seeds.end - seeds.first) / 2);
  CHECK(reduced > compared / 20);
}

} // namespace proskill::test::watchers_test
