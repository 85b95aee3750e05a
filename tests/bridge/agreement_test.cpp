#include "bridge/bt/import.h"
#include "bridge/bt/read/read.h"
#include "bridge/bt/tree/expand.h"
#include "codegen/model.h"
#include "tests/bridge/random_tree.h"
#include "tests/bridge/ticker.h"
#include "tests/support/memory_files.h"
#include "tests/support/random/seeds.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

using namespace proskill;
using namespace proskill::test;

namespace {

constexpr std::size_t kLimit = 3000;

/// Questions about what the ticker observes, by the names of their properties.
std::string questions(const std::set<std::string>& actions) {
  std::string text = "(defproperty q_success (reachable (ended Main success)))\n"
                     "(defproperty q_failure (reachable (ended Main failure)))\n";
  for (const auto& a : actions) {
    text += fmt::format("(defproperty q_{0} (reachable (running {0})))\n", a);
    for (const auto& b : actions)
      if (a < b)
        text += fmt::format(
            "(defproperty q_{0}_{1} (reachable (and (running {0}) (running {1}))))\n", a, b);
  }
  return text;
}

void actionsOf(const bridge::bt::Node& node, std::set<std::string>& names) {
  if (node.kind == bridge::bt::Kind::Action) names.insert(node.name);
  for (const auto& child : node.children) actionsOf(child, names);
}

void note(const std::string& question, Observed& observed) {
  const auto rest = question.substr(2);
  const auto bar = rest.find('_');
  if (rest == "success")
    observed.success = true;
  else if (rest == "failure")
    observed.failure = true;
  else if (bar == std::string::npos)
    observed.started.insert(rest);
  else
    observed.together.emplace(rest.substr(0, bar), rest.substr(bar + 1));
}

/// What the verifier says about a program.
std::optional<Observed> verified(const std::string& text) {
  const MemoryFiles files({{"main.proskill", text}});
  const auto program = analysis::load(files, "main.proskill");
  for (const auto& finding : analysis::check(program))
    if (finding.severity == syntax::Severity::Error) FAIL(finding.message << "\n" << text);
  const auto model = codegen::generate(program, {});
  REQUIRE(model);
  std::vector<const codegen::Check*> checks;
  std::vector<verify::Question> asked;
  for (const auto& check : model->checks)
    if (check.name.starts_with("q_")) {
      checks.push_back(&check);
      asked.push_back({check.property, check.fair});
    }
  const auto result =
      verify::verify(model->fiacre, model->provenance, asked, {.limits = {.classes = 30'000}});
  REQUIRE(result);
  Observed observed;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    if (result->answers[i].truth == verify::Truth::Unknown) return std::nullopt;
    if (result->answers[i].truth == verify::Truth::False) note(checks[i]->name, observed);
  }
  return observed;
}

struct Counts {
  std::size_t exact = 0;
  std::size_t approximate = 0;
  std::size_t refused = 0;
  std::size_t tooLarge = 0;
};

void compare(std::uint64_t seed, const bridge::bt::Leaves& leaves, Counts& counts) {
  const auto xml = randomTree(seed);
  const MemoryFiles files({{"tree.xml", xml}});
  const auto imported = bridge::bt::importTree(files, "tree.xml", leaves);
  if (!imported) return static_cast<void>(++counts.refused);
  const auto tree = bridge::bt::expand(*bridge::bt::read(files, "tree.xml"));
  const auto expected = observe(*tree, leaves, kLimit);
  std::set<std::string> actions;
  actionsOf(*tree, actions);
  std::erase_if(actions, [&](const auto& name) {
    return imported->text.find("(defskill " + name + "\n") == std::string::npos;
  });
  const auto found = expected ? verified(imported->text + questions(actions)) : std::nullopt;
  if (!found) return static_cast<void>(++counts.tooLarge);
  ++(imported->exact ? counts.exact : counts.approximate);
  INFO("seed " << seed << "\n" << xml << "\n" << imported->text);
  INFO("ticked:   " << inWords(*expected) << "\nverified: " << inWords(*found));
  if (imported->exact) REQUIRE(*found == *expected);
  REQUIRE(covers(*found, *expected));
}

} // namespace

TEST_CASE("the verdicts on random trees are those of an interpreter of ticks") {
  const auto leaves = bridge::bt::Leaves::read(kRandomLeaves);
  REQUIRE(leaves);
  Counts counts;
  const auto seeds = seedsOr(1, 2000);
  for (auto seed = seeds.first; seed < seeds.end; ++seed) compare(seed, *leaves, counts);
  INFO(counts.exact << " exact, " << counts.approximate << " approximate, " << counts.refused
                    << " refused, " << counts.tooLarge << " too large");
  const auto compared = counts.exact + counts.approximate;
  CHECK(compared * 10 >= (seeds.end - seeds.first) * 7);
  CHECK(counts.exact > counts.approximate);
}
