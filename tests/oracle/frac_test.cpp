#include "tests/oracle/agreement.h"
#include "tests/support/random/random_program.h"
#include "tests/support/random/seeds.h"
#include "tests/support/texts.h"

#include "codegen/model.h"
#include "fiacre/check/check.h"

#include <catch2/catch.hpp>

using namespace proskill;
using codegen::Edition;

namespace {

constexpr std::uint64_t kFracPrograms = 400;
constexpr std::size_t kFracLimit = 2500; ///< nodes of a region graph

std::optional<codegen::Model> modelOf(const std::vector<test::Form>& forms, Edition edition) {
  const auto program = test::programOfText(test::textOf(forms));
  if (!test::isWellFormed(program)) return std::nullopt;
  auto model = codegen::generate(program, {.edition = edition});
  if (!model) return std::nullopt;
  return std::move(*model);
}

/// Where the engine and frac's interpretation of an edition differ; empty if it is too large.
std::optional<std::string> difference(const codegen::Model& model, bool& decided) {
  const auto judged = oracle::judge(model.fiacre, kFracLimit, oracle::Reading::Frac);
  decided = judged.complete;
  if (!judged.complete) return std::nullopt;
  return oracle::disagreement(model.fiacre, model.provenance, judged, oracle::settings().front());
}

} // namespace

TEST_CASE(
    "to frac, for which each path has a clock of its own, the edition for Tina means the same") {
  std::size_t compared = 0;
  const auto [first, end] = test::seedsOr(0, kFracPrograms);
  for (auto seed = first; seed < end; ++seed) {
    const auto forms = test::randomProgram(seed, test::varied(seed));
    const auto model = modelOf(forms, Edition::Tina);
    if (!model) continue;
    bool decided = false;
    const auto found = difference(*model, decided);
    compared += decided;
    INFO("seed " << seed << "\n" << test::textOf(forms));
    CHECK(found.value_or("") == "");
  }
  WARN(compared << " programs compared");
  CHECK(compared > (end - first) / 10);
}

/// The skill takes 2 s; the environment changes `door` at 1 s. The end of `open` tests `door` after
/// its wait: two paths, of which the second starts its clock when the test changes.
constexpr std::string_view kTestBehindAWait = R"((defsv door :states (Shut Open Jammed) :init Shut
  :transitions ((Shut Open) (Open Shut) (Jammed Shut) (Shut Jammed)))
(defevent slam :effects (door Open))
(defskill open :time_interval [2,2] :action (open) :success (ok (:effects (door Jammed))))
(defskill mission :time_interval [2,2] :success done :body ((open) (success done)))
(defenvironment world :body ((^ 1) (emit slam)))
)";

TEST_CASE("the compact edition means something else to frac, the edition for Tina does not") {
  const auto differs = [](Edition edition) {
    const auto program = test::programOfText(std::string(kTestBehindAWait));
    REQUIRE(test::isWellFormed(program));
    const auto model = codegen::generate(program, {.edition = edition}).value();
    bool decided = false;
    const auto found = difference(model, decided);
    REQUIRE(decided);
    return found.has_value();
  };
  CHECK(differs(Edition::Compact));
  CHECK_FALSE(differs(Edition::Tina));
}
