#include "bridge/bt/composites.h"

#include <algorithm>

namespace proskill::bridge::bt {
namespace {

/// One branch, or several in parallel.
Block together(std::vector<Block> branches) {
  std::erase_if(branches, [](const Block& branch) { return branch.empty(); });
  if (branches.empty()) return {};
  if (branches.size() == 1) return branches.front();
  Form form = list("//");
  for (auto& branch : branches) form.parts.emplace_back(std::move(branch));
  return {form};
}

constexpr auto kAnyOrder = "children may begin in any order, although some may end at once";

bool endsSkill(const Exit& exit) { return exit == succeed() || exit == fail(); }

Form countUp(const std::string& counter) {
  return list("set", list(counter, list("+", counter, "1")));
}

/// Counts an end, and leaves when it is the last one needed.
struct Tally {
  std::string counter; ///< empty: the first one ends the node
  std::int64_t needed = 1;
  Exit exit;

  /// Whether the branch ends without ending the node.
  [[nodiscard]] bool goesOn() const { return exit.next() || !counter.empty(); }

  [[nodiscard]] Block statements() const {
    if (counter.empty()) return exit.jump;
    Form test = list("if", list(">=", counter, std::to_string(needed)));
    append(test.parts, exit.jump);
    return {countUp(counter), test};
  }
};

} // namespace

Block Composites::parallel(const Node& node) {
  const auto thresholds = thresholdsOf(node);
  if (!thresholds) {
    vocabulary.fail(node, "`success_count` and `failure_count` must be numbers from 1 to the "
                          "number of children, or negative");
    return fail().jump;
  }
  const auto count = static_cast<std::int64_t>(node.children.size());
  Block statements;
  const auto tally = [&](std::int64_t needed, const char* suffix, const Exit& exit) {
    if (needed == 1) return Tally{{}, 1, exit};
    const auto counter = vocabulary.counter(node, suffix, count);
    statements.push_back(list("set", list(counter, "0")));
    return Tally{counter, needed, exit};
  };
  const bool allMust = thresholds->successes == count;
  const bool oneSuffices = !allMust && thresholds->successes == 1 && thresholds->failures == count;
  const auto ends = traits.endsInside(node);
  const auto good = allMust ? Tally{} : tally(thresholds->successes, "_successes", succeed());
  const auto bad = oneSuffices ? Tally{} : tally(thresholds->failures, "_failures", fail());
  append(statements, branches(node, {good.statements()}, {bad.statements()}));
  const bool allEnd = std::ranges::all_of(node.children, [&](const Node& child) {
    const auto [succeeds, fails] = traits.ends(child);
    return (succeeds && good.goesOn()) || (fails && bad.goesOn());
  });
  if (allEnd && allMust && ends.success) append(statements, succeed().jump);
  if (allEnd && !allMust && ends.failure) append(statements, fail().jump);
  return statements;
}

Block Composites::branches(const Node& node, const Exit& success, const Exit& failure) {
  std::vector<Block> blocks;
  const auto groups = branchesOf(node, traits);
  for (const auto& group : groups) {
    Body body(vocabulary);
    for (const auto* child : group) body.result(*child, success, failure);
    blocks.push_back(std::move(body.statements));
  }
  const bool mixed =
      groups.size() > 1 && std::ranges::any_of(node.children, [&](const Node& child) {
        return traits.mayEndAtOnce(child);
      });
  if (mixed) vocabulary.approximate(node, kAnyOrder);
  return together(std::move(blocks));
}

void Body::result(const Node& child, Exit success, Exit failure) {
  std::string after;
  for (auto* exit : {&success, &failure}) {
    if (exit->next() || endsSkill(*exit)) continue;
    if (after.empty()) after = vocabulary.names.take("counted");
    exit->jump.push_back(list("goto", after));
  }
  node(child, success, failure);
  placeUsed(after);
}

void Body::parallelAll(const Node& node, const Exit& success, const Exit& failure) {
  const auto needed = failuresOf(node);
  if (!needed)
    return vocabulary.fail(node,
                           "`max_failures` must be a number from 1 to the number of children, "
                           "or negative");
  const auto count = static_cast<std::int64_t>(node.children.size());
  const auto failures = vocabulary.counter(node, "_failures", count);
  statements.push_back(list("set", list(failures, "0")));
  std::vector<Block> blocks;
  const auto groups = branchesOf(node, traits);
  // An action that ends at once does not run beside those after it.
  if (groups.size() > 1 && traits.hasInstantAction(node)) vocabulary.approximate(node, kAnyOrder);
  for (const auto& group : groups) {
    Body body(vocabulary);
    for (const auto* child : group) body.result(*child, {}, {{countUp(failures)}});
    blocks.push_back(std::move(body.statements));
  }
  append(statements, together(std::move(blocks)));
  const auto ends = traits.endsInside(node);
  if (!ends.success || !ends.failure) return leave(ends.success ? success : failure);
  const auto at = statements.size();
  const Form failed = list(">=", failures, std::to_string(*needed));
  if (failure.next())
    test(list("<", failures, std::to_string(*needed)), success);
  else
    test(failed, failure);
  if (!failure.next()) leave(success);
  commentAt(at, node);
}

} // namespace proskill::bridge::bt
