#pragma once

#include "bridge/bt/program/vocabulary.h"

namespace proskill::bridge::bt {

/// What nodes made of conditions return, as a condition of ProSkill. A tick reads one condition
/// after the other, and each may change in between. So each place that watches a condition has a
/// variable of its own.
class Guard {
public:
  explicit Guard(Vocabulary& vocabulary) : vocabulary(vocabulary) {}

  /// When the node succeeds, or with `negated`, when it fails. `true` and `false` are words.
  /// \pre the node is pure
  Form of(const Node& node, bool negated);
  /// When all of the first `count` children have this result, or not all of them.
  Form ofAll(const Node& node, std::size_t count, bool negatedEach, bool negatedAll);

private:
  /// Each choice says what its test needs twice, so that a condition grows fast with nesting.
  static constexpr int kMostChoices = 40'000;

  Form leaf(const Node& node, bool negated);
  Form joined(const char* word, const std::vector<Form>& parts);
  Form joinedChildren(const Node& node, std::size_t count, bool isAnd, bool negated);
  Form choice(const Node& node, bool negated);

  Vocabulary& vocabulary;
  std::map<const Node*, std::string> variables;
  int choices = 0;
};

} // namespace proskill::bridge::bt
