#include "groot/block.h"

#include "bridge/bt/tree/tree.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>

namespace proskill::groot {

namespace {

using syntax::Statement;
using syntax::StatementKind;
using Attributes = std::vector<std::pair<std::string, std::string>>;

/// Elements of statements that BehaviorTree.CPP does not have.
constexpr std::array<std::string_view, 14> kOwnTags = {
    "Test",  "WaitUntil", "WaitFor", "Set",  "Print",   "Emit",   "Interrupt",
    "Break", "Goto",      "Succeed", "Fail", "Unknown", "Choose", "Case"};

/// A leaf's element has the name of its skill, unless another node has it.
std::string tagOf(std::string_view skill) {
  const bool isTaken =
      bridge::bt::builtIn(skill) || std::ranges::find(kOwnTags, skill) != kOwnTags.end();
  return std::string(skill) + (isTaken ? "_skill" : "");
}

/// Ports must not be called as the attributes that all nodes have.
std::string portOf(std::string_view argument) {
  const bool isReserved = argument == "name" || argument == "ID" || argument.starts_with('_');
  return isReserved ? "of_" + std::string(argument) : std::string(argument);
}

class Builder {
public:
  Builder(const analysis::Program& of, const analysis::Definition<syntax::Skill>& skill)
      : program(of), text(of.files[skill.file].document.text()) {
    block.skill = &skill;
    block.name = skill.name();
  }

  Block body() {
    const auto root = open(NodeKind::Control, "Sequence");
    statements(*block.skill->node().body);
    close(root);
    return std::move(block);
  }

private:
  NodeIndex open(NodeKind kind, std::string tag, Attributes attributes = {}) {
    const auto index = static_cast<NodeIndex>(block.nodes.size());
    block.nodes.push_back({kind, std::move(tag), std::move(attributes), {}, parent, 0});
    parent = index;
    return index;
  }
  void close(NodeIndex node) {
    block.nodes[node].end = static_cast<NodeIndex>(block.nodes.size());
    parent = block.nodes[node].parent;
  }
  NodeIndex leaf(NodeKind kind, std::string tag, Attributes attributes = {}) {
    const auto node = open(kind, std::move(tag), std::move(attributes));
    close(node);
    return node;
  }
  void stand(syntax::Range range, NodeIndex node) {
    block.at.emplace(std::pair(range.begin, range.end), node);
  }
  void at(const Statement& statement, NodeKind kind, std::string tag, Attributes attributes = {}) {
    stand(statement.range, leaf(kind, std::move(tag), std::move(attributes)));
  }

  /// The program's text, in one line.
  [[nodiscard]] std::string written(syntax::Range range) const {
    std::string line;
    for (const char letter : text.substr(range.begin, range.length())) {
      const bool isSpace = std::isspace(static_cast<unsigned char>(letter)) != 0;
      if (!isSpace) line += letter;
      if (isSpace && !line.empty() && line.back() != ' ') line += ' ';
    }
    return line;
  }

  void sequence(const syntax::Block& body) {
    const auto isLabel = [](const Statement& it) { return it.kind == StatementKind::Label; };
    const auto count = std::ranges::count_if(body.statements, std::not_fn(isLabel));
    const auto node = count > 1 ? open(NodeKind::Control, "Sequence") : 0;
    statements(body);
    if (count > 1) close(node);
  }

  void statements(const syntax::Block& body) {
    const auto before = block.nodes.size();
    for (const auto& statement : body.statements) add(statement);
    if (block.nodes.size() == before) leaf(NodeKind::Leaf, "AlwaysSuccess");
  }

  void add(const Statement& it) {
    const auto name = std::string(it.name.text);
    switch (it.kind) {
    case StatementKind::Unknown: return at(it, NodeKind::Leaf, "Unknown");
    case StatementKind::Call: return call(it);
    case StatementKind::Interrupt:
      return at(it, NodeKind::Leaf, "Interrupt", {{"statement", written(it.range)}});
    case StatementKind::WaitCondition: return wait(it);
    case StatementKind::WaitTime:
      return at(it, NodeKind::Leaf, "WaitFor", {{"statement", written(it.range)}});
    case StatementKind::If: return choice(it, 0);
    case StatementKind::Case: return caseOf(it);
    case StatementKind::While: return loop(it, true);
    case StatementKind::DoUntil: return loop(it, false);
    case StatementKind::Break: return at(it, NodeKind::Leaf, "Break");
    case StatementKind::Label: return;
    case StatementKind::Goto: return at(it, NodeKind::Leaf, "Goto", {{"label", name}});
    case StatementKind::Parallel: return branches(it, {{"failure_count", "1"}});
    case StatementKind::Race: return branches(it, {{"name", "race"}, {"success_count", "1"}});
    case StatementKind::Set:
      return at(it, NodeKind::Leaf, "Set", {{"statement", written(it.range)}});
    case StatementKind::Printf:
      return at(it, NodeKind::Leaf, "Print", {{"message", std::string(it.format.text)}});
    case StatementKind::Success: return at(it, NodeKind::Leaf, "Succeed", {{"with", name}});
    case StatementKind::Failure: return at(it, NodeKind::Failing, "Fail", {{"with", name}});
    case StatementKind::Emit: return at(it, NodeKind::Leaf, "Emit", {{"event", name}});
    case StatementKind::Choose: return choose(it);
    }
  }

  void call(const Statement& it) {
    Attributes given;
    for (const auto& argument : it.arguments)
      given.emplace_back(portOf(argument.name.text), written(argument.value.range));
    const auto* callee = program.skills.find(it.head.text);
    const bool isTree = callee && callee->node().isComposite();
    if (isTree) given.emplace(given.begin(), "ID", it.head.text);
    at(it, isTree ? NodeKind::SubTree : NodeKind::Call, isTree ? "SubTree" : tagOf(it.head.text),
       std::move(given));
    block.nodes.back().skill = it.head.text;
  }

  NodeIndex test(syntax::Range condition) {
    return leaf(NodeKind::Test, "Test", {{"condition", written(condition)}});
  }

  void wait(const Statement& it) {
    const Attributes until{{"condition", written(it.condition.range)}};
    if (it.branches.empty()) return at(it, NodeKind::Leaf, "WaitUntil", until);
    const auto either = open(NodeKind::Control, "Fallback");
    at(it, NodeKind::Timed, "WaitUntil", until);
    sequence(it.branches.front());
    close(either);
  }

  /// The arms from this one on. A process tests all conditions at once, at the first of them.
  void choice(const Statement& it, std::size_t arm) {
    const auto& tested = it.arms[arm];
    if (!tested.condition) return sequence(tested.body);
    const auto node = open(NodeKind::Choice, "IfThenElse");
    const auto first = test(tested.condition->range);
    if (arm == 0) stand(it.range, first);
    sequence(tested.body);
    if (arm + 1 < it.arms.size()) choice(it, arm + 1);
    close(node);
  }

  void caseOf(const Statement& it) {
    const auto node = open(NodeKind::Control, "Case");
    for (const auto& called : it.branches) sequence(called);
    for (const auto& arm : it.arms) sequence(arm.body);
    close(node);
  }

  void loop(const Statement& it, bool testsFirst) {
    const auto node = open(NodeKind::Loop, "Repeat", {{"num_cycles", "-1"}});
    const auto round = open(NodeKind::Control, "Sequence");
    if (testsFirst) stand(it.range, test(it.condition.range));
    for (const auto& body : it.branches) sequence(body);
    if (!testsFirst) stand(it.range, test(it.condition.range));
    close(round);
    close(node);
  }

  void branches(const Statement& it, Attributes attributes) {
    const auto node = open(NodeKind::Parallel, "Parallel", std::move(attributes));
    stand(it.range, node);
    for (const auto& branch : it.branches) sequence(branch);
    close(node);
  }

  void choose(const Statement& it) {
    const auto node = open(NodeKind::Control, "Choose");
    stand(it.range, node);
    for (const auto& branch : it.branches) sequence(branch);
    close(node);
  }

  const analysis::Program& program;
  std::string_view text;
  Block block;
  NodeIndex parent = 0;
};

} // namespace

Block blockOf(const analysis::Program& program, const analysis::Definition<syntax::Skill>& skill) {
  return Builder(program, skill).body();
}

Block blockOf(const analysis::Program& program, const std::vector<std::string>& skills) {
  Block block{.name = "program"};
  while (program.skills.find(block.name)) block.name += '_';
  const auto count = static_cast<NodeIndex>(skills.size());
  block.nodes.push_back(
      {NodeKind::Parallel, "Parallel", {{"failure_count", "1"}}, {}, 0, count + 1});
  for (NodeIndex i = 0; i < count; ++i)
    block.nodes.push_back({NodeKind::SubTree, "SubTree", {{"ID", skills[i]}}, skills[i], 0, i + 2});
  return block;
}

} // namespace proskill::groot
