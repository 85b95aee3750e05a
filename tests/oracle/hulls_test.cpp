#include "tests/oracle/agreement.h"
#include "tests/support/random/random_model.h"
#include "tests/support/random/seeds.h"

#include "fiacre/print/print.h"
#include "verify/compile/compile.h"
#include "verify/explore/search.h"
#include "verify/reduce/prepared.h"
#include "verify/slice/slicer.h"

#include <catch2/catch.hpp>

#include <array>
#include <optional>

namespace proskill::test::hulls_test {

namespace {

constexpr std::size_t kLimit = 6000; ///< nodes of a region graph

/// Whether hulls show that the property's goal is never reached. Nothing if it is not a question
/// for them.
/// \param most hulls of a state before they are widened
std::optional<bool> isShownNever(const fiacre::Program& program, std::size_t property,
                                 std::uint8_t most) {
  const auto compiled = verify::compile(program, {}, {{property}});
  REQUIRE(compiled.has_value());
  const verify::Options options;
  const auto takes = [&](verify::Reduction reduction) {
    return verify::mayTake(reduction, options, compiled->system);
  };
  if (!verify::Slicer::canDecide(compiled->goals[0]) || !takes(verify::Reduction::Inclusion))
    return std::nullopt;
  verify::LimitWatch limits(options);
  const verify::Prepared prepared(compiled->system, compiled->goals, takes, limits);
  verify::Reductions reductions = prepared.reductions;
  reductions.hull = true;
  reductions.mostHulls = most;
  const auto found = verify::search(prepared.system, compiled->goals, reductions,
                                    prepared.extrapolation, limits, [](auto&&...) {});
  return !found.failure && found.statistics.complete && !found.goals[0];
}

struct Counts {
  std::size_t never = 0; ///< questions whose goals are never reached
  std::size_t shown = 0; ///< those of them that hulls show
  std::size_t reached = 0;
};

void judge(const fiacre::Program& program, std::uint8_t most, Counts& counts) {
  const auto judged = oracle::judge(program, kLimit);
  if (!judged.complete) return;
  for (std::size_t i = 0; i < program.properties.size(); ++i) {
    if (!judged.truths[i]) continue;
    const auto shown = isShownNever(program, i, most);
    if (!shown) continue;
    INFO("property " << i);
    if (!*judged.truths[i]) CHECK_FALSE(*shown);
    ++(*judged.truths[i] ? counts.never : counts.reached);
    counts.shown += *shown ? 1 : 0;
  }
}

} // namespace

TEST_CASE("what hulls of zones show never to happen never happens in random models") {
  const auto [first, end] = seedsOr(0, 300);
  for (const std::uint8_t most : std::array<std::uint8_t, 2>{0, 2}) {
    INFO("widened after " << int{most} << " hulls");
    Counts counts;
    for (auto seed = first; seed < end; ++seed)
      for (const auto& program : {randomModel(seed), randomModelWithData(seed)}) {
        INFO("seed " << seed << '\n' << fiacre::print(program));
        judge(program, most, counts);
      }
    CHECK(counts.reached > 10);
    CHECK(counts.never > 10);
    CHECK(counts.shown > counts.never / 2);
  }
}

} // namespace proskill::test::hulls_test
