#include "fiacre/syntax/parse.h"
#include "tests/oracle/agreement.h"
#include "tests/support/random/random_source.h"
#include "tests/support/random/seeds.h"

#include "fiacre/check/check.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

namespace proskill::test::parts_test {

namespace {

constexpr std::size_t kLimit = 4000; ///< nodes of a region graph

/// Workers that share nothing but a barrier: some of their steps wait until no alarm is on. A
/// coordinator may call them and wait until they have ended, or a caller may call each that is
/// free. Sometimes they take turns at a tool, too.
class RandomParts {
public:
  explicit RandomParts(std::uint64_t seed)
      : random(seed),
        count(random.chance(30) ? 3 : 2),
        isCoordinated(random.chance(50)),
        isCalled(!isCoordinated && random.chance(60)),
        hasBarrier(random.chance(70)),
        isBarrierWhole(random.chance(80)),
        hasTool(random.chance(40)) {}

  std::string text() {
    std::string made;
    for (std::size_t i = 0; i < count; ++i) made += worker(i);
    if (isCoordinated) made += coordinator();
    if (isCalled) made += caller();
    made += "component main is var " + fmt::format("{}", fmt::join(variables(), ", ")) +
            " par * in " + fmt::format("{}", fmt::join(instances(), " || ")) + " end main\n" +
            "property p0 is deadlockfree assert p0\n";
    for (std::size_t i = 0; i < count; ++i)
      for (const auto* location : {"idle", "a", "b"})
        made += fmt::format("property q{0}{1} is absent main/{2}/state {1} assert q{0}{1}\n", i,
                            location, i + 1);
    return made;
  }

private:
  [[nodiscard]] std::vector<std::string> each(const std::string& format) const {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(fmt::format(fmt::runtime(format), i));
    return all;
  }

  std::vector<std::string> variables() {
    auto all = each("x{0}: 0..2 := 0");
    all.emplace_back("taken: bool := false");
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back(fmt::format("alarm{}: bool := {}", i, random.chance(20)));
      all.push_back(fmt::format("called{}: bool := {}", i, !isCoordinated && !isCalled));
    }
    return all;
  }

  [[nodiscard]] std::vector<std::string> instances() const {
    const auto shared =
        fmt::format("&taken, {}", fmt::join(each("&x{0}, &alarm{0}, &called{0}"), ", "));
    std::vector<std::string> all = each("Worker{0}(" + shared + ")");
    if (isCoordinated) all.push_back("Coordinator(" + shared + ")");
    if (isCalled) all.push_back("Caller(" + shared + ")");
    return all;
  }

  [[nodiscard]] std::string parameters() const {
    return fmt::format("(&taken: bool, {})",
                       fmt::join(each("&x{0}: 0..2, &alarm{0}: bool, &called{0}: bool"), ", "));
  }

  /// That no alarm is on, or sometimes only that one of another part is not.
  std::string barrier(std::size_t i) {
    if (isBarrierWhole) return fmt::format("not ({})", fmt::join(each("alarm{0}"), " or "));
    return fmt::format("not alarm{}", (i + 1) % count);
  }

  std::string worker(std::size_t i) {
    std::string made = fmt::format("process Worker{} {} is states idle, a, b\n", i, parameters());
    made += fmt::format("from idle {} on called{}; {} to a\n", urgent(i), i, assignment(i));
    for (const auto* location : {"a", "b"}) {
      std::vector<std::string> steps;
      for (std::size_t k = random.below(2) + 1; k > 0; --k) steps.push_back(step(i));
      if (random.chance(85)) steps.push_back(calming(i));
      made += fmt::format("from {} select {} end\n", location, fmt::join(steps, " [] "));
    }
    return made;
  }

  std::string urgent(std::size_t i) {
    return "wait [0,0]; " + (hasBarrier && random.chance(60) ? "on " + barrier(i) + "; " : "");
  }

  /// Takes back the alarm at once.
  std::string calming(std::size_t i) {
    return fmt::format("wait [0,0]; on alarm{0}; alarm{0} := {1}; to {2}", i, random.chance(10),
                       random.chance(50) ? "a" : "b");
  }

  std::string step(std::size_t i) {
    const std::vector<std::string> waits{"wait [1,1]; ", "wait [0,1]; ", "wait [1,...[; ",
                                         "wait ]0,1]; "};
    std::string made = random.chance(50) ? urgent(i) : random.pick(waits);
    if (random.chance(60))
      made += fmt::format("on x{} {} {}; ", i, random.chance(50) ? "=" : "<>", random.below(3));
    if (hasTool && random.chance(60))
      made += random.chance(50) ? "on not taken; taken := true; " : "taken := false; ";
    made += assignment(i);
    if (random.chance(30)) made += fmt::format("alarm{} := true; ", i);
    if (random.chance(40)) return made + fmt::format("called{} := false; to idle", i);
    return made + (random.chance(50) ? "to a" : "to b");
  }

  std::string assignment(std::size_t i) {
    if (random.chance(40)) return "";
    return fmt::format("x{} := {}; ", i, random.below(3));
  }

  std::string coordinator() {
    const std::vector<std::string> ends{"wait [0,...[; loop", "wait [1,1]; to start",
                                        "wait [1,2]; loop"};
    return fmt::format("process Coordinator {} is states start, join_, end_\n"
                       "from start wait [0,0]; {}; to join_\n"
                       "from join_ wait [0,0]; on not ({}); to end_\nfrom end_ {}\n",
                       parameters(), fmt::join(each("called{0} := true"), "; "),
                       fmt::join(each("called{0}"), " or "), random.pick(ends));
  }

  /// Its only location has a step for each worker, or for some.
  std::string caller() {
    std::vector<std::string> steps;
    for (std::size_t i = 0; i < count; ++i)
      if (random.chance(85))
        steps.push_back(fmt::format("on {} called{}; wait {}; called{} := true; loop",
                                    random.chance(90) ? "not" : "", i,
                                    random.chance(60) ? "[0,...[" : "[1,2]", i));
    if (steps.empty()) steps.emplace_back("wait [1,1]; loop");
    return fmt::format("process Caller {} is states start_\nfrom start_ select {} end\n",
                       parameters(), fmt::join(steps, " [] "));
  }

  RandomSource random;
  std::size_t count;
  bool isCoordinated;
  bool isCalled;
  bool hasBarrier;
  bool isBarrierWhole;
  bool hasTool;
};

/// The model with a question about time as well, which has no text in Fiacre.
fiacre::Program modelOf(const std::string& text) {
  auto parsed = fiacre::parse(text);
  for (const auto& problem : parsed.problems) FAIL(problem.message << "\n" << text);
  for (const auto& problem : fiacre::check(parsed.program)) FAIL(problem.message << "\n" << text);
  auto& properties = parsed.program.properties;
  properties.push_back(properties.front());
  properties.back().name = "progress";
  properties.back().pattern = {.kind = fiacre::PatternKind::Progress};
  return std::move(parsed.program);
}

/// Whether slices answer the question alone.
bool isSliced(const fiacre::Program& program, std::size_t property,
              std::optional<verify::Reduction> without = {}) {
  verify::Options options;
  if (without) options.reductions.erase(*without);
  options.classesBeforeSlices = 0;
  const auto result = verify::verify(program, {}, {{property}}, options);
  return result && result->exploration.sliced == 1;
}

} // namespace

TEST_CASE("engine and oracle agree on random models of independent parts") {
  std::size_t judgedModels = 0;
  std::size_t deadlocks = 0;
  std::size_t stuck = 0;
  std::size_t withoutDeadlock = 0;
  std::size_t withoutStop = 0;
  std::size_t byInstances = 0;
  const auto [first, end] = seedsOr(0, 1000);
  for (auto seed = first; seed < end; ++seed) {
    const auto text = RandomParts(seed).text();
    INFO("seed " << seed << "\n" << text);
    const auto program = modelOf(text);
    const auto judged = oracle::judge(program, kLimit);
    if (!judged.complete) continue;
    ++judgedModels;
    const auto last = program.properties.size() - 1;
    deadlocks += judged.truths[0] == false ? 1 : 0;
    stuck += judged.truths[last] == false ? 1 : 0;
    withoutDeadlock += isSliced(program, 0) ? 1 : 0;
    withoutStop += isSliced(program, last) ? 1 : 0;
    byInstances += isSliced(program, last, verify::Reduction::Slices) ? 1 : 0;
    for (const auto& setting : oracle::settings()) {
      if (setting.second.classesBeforeSlices > 5) continue;
      const auto wrong = oracle::disagreement(program, {}, judged, setting);
      INFO(wrong.value_or(""));
      REQUIRE_FALSE(wrong);
    }
  }
  INFO(judgedModels << " models, " << deadlocks << " deadlocks, " << stuck << " stuck; by parts: "
                    << withoutDeadlock << " without a deadlock, " << withoutStop
                    << " in which time goes on, instance by instance " << byInstances);
  CHECK(judgedModels > 0);
  CHECK(withoutDeadlock > 10);
  CHECK(withoutStop > 10);
  CHECK(byInstances > 10);
  CHECK(deadlocks > 10);
  CHECK(stuck > 10);
}

} // namespace proskill::test::parts_test
