#include "bridge/bt/import.h"

#include "bridge/bt/composites.h"
#include "bridge/bt/read/read.h"
#include "bridge/bt/simplify/simplify.h"
#include "bridge/bt/tree/expand.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace proskill::bridge::bt {
namespace {

/// The main tree as a use of itself.
Node missionOf(const Forest& forest, Node root) {
  Node mission{Kind::SubTree, forest.main, {}, forest.trees.at(forest.main).place, {}, {}};
  mission.children.push_back(std::move(root));
  return mission;
}

/// That the tree can end is asked for, whatever it ends with.
Form endProperty(Vocabulary& vocabulary, const std::string& main) {
  return list("defproperty", vocabulary.names.take(main + "_can_end"),
              list("reachable", list("ended", main)));
}

/// Actions of Nav2 that return a result in each tick. A selector takes the name that came last on a
/// topic, the others read or change a path or a list of goals.
constexpr std::array kInstantActions{
    "ControllerSelector", "GetPoseFromPath",   "GoalCheckerSelector",     "PathHandlerSelector",
    "PlannerSelector",    "RemovePassedGoals", "ProgressCheckerSelector", "SmootherSelector",
    "TruncatePath",       "TruncatePathLocal"};

std::string verdictLine(const Vocabulary& vocabulary) {
  if (vocabulary.notes.empty())
    return "verdicts are exact for this tree: its leaves take the times and have the results that "
           "are allowed to them, its conditions may change at any time, and it is ticked at any "
           "time";
  return "verdicts are over-approximate: what holds or is unreachable in the program is so in the "
         "tree; a violation may be one of the program alone";
}

std::vector<std::string> summaryOf(const Vocabulary& vocabulary, const Forest& forest,
                                   const std::set<std::string>& instant) {
  std::vector<std::string> lines;
  if (!forest.hasFormat) lines.emplace_back("`BTCPP_format` is not 4: read as version 4");
  if (!forest.undeclared.empty())
    lines.push_back(fmt::format("not declared in `TreeNodesModel`, taken as actions: {}",
                                fmt::join(forest.undeclared, ", ")));
  if (!instant.empty())
    lines.push_back(fmt::format("actions of Nav2 that end in the tick that starts them, unless a "
                                "file of `--leaves` says otherwise: {}",
                                fmt::join(instant, ", ")));
  if (!forest.own.empty())
    lines.push_back(fmt::format("not built in, taken as control nodes and decorators of the "
                                "author, which halt their children before they end: {}",
                                fmt::join(forest.own, ", ")));
  for (const auto* notes : {&forest.notes, &vocabulary.remarks})
    for (const auto& note : *notes)
      lines.push_back(fmt::format("{}: {}", asText(note.place, {}), note.message));
  for (const auto& name : vocabulary.leaves.unused())
    lines.push_back(
        fmt::format("no node is called `{}`, of which the file of leaves speaks", name));
  for (const auto& [type, name] : vocabulary.commands)
    if (type != name) lines.push_back(fmt::format("the action of `{}` is called `{}`", type, name));
  for (const auto& note : vocabulary.notes)
    lines.push_back(asText(note.place, {}) + ": approximated: " + note.message);
  lines.push_back(verdictLine(vocabulary));
  return lines;
}

Leaves withInstantActions(Leaves leaves) {
  for (const auto* type : kInstantActions) leaves.assumeInstant(type);
  return leaves;
}

/// The types of actions that were assumed to be instant.
void findInstant(const Node& node, const Leaves& leaves, std::set<std::string>& types) {
  if (node.kind == Kind::Action &&
      std::ranges::find(kInstantActions, node.id) != kInstantActions.end())
    if (const auto& leaf = leaves.of(node.name, node.id); leaf.isInstant() && !leaf.hasDuration)
      types.insert(node.id);
  for (const auto& child : node.children) findInstant(child, leaves, types);
}

void remarkUnticked(Vocabulary& vocabulary, const Block& program) {
  const auto called = calledIn(program);
  for (const auto& [name, place] : vocabulary.actions)
    if (!called.contains(name))
      vocabulary.remarks.push_back({place, fmt::format("`{}` is never ticked", name)});
}

/// The side file may say that a leaf is a condition, which a tree alone need not.
void setKinds(Node& node, const Leaves& leaves) {
  const bool isLeaf =
      node.kind == Kind::Action || (node.kind == Kind::Condition && node.id != "ScriptCondition");
  if (const auto isCondition = leaves.of(node.name, node.id).isCondition; isLeaf && isCondition)
    node.kind = *isCondition ? Kind::Condition : Kind::Action;
  for (auto& child : node.children) setKinds(child, leaves);
}

} // namespace

std::expected<Imported, Errors> importTree(const analysis::FileSystem& files,
                                           const std::filesystem::path& root, const Leaves& given,
                                           const std::filesystem::path& folder,
                                           const std::string& chosen) {
  const auto forest = read(files, root, chosen);
  if (!forest) return std::unexpected(forest.error());
  auto tree = expand(*forest);
  if (!tree) return std::unexpected(tree.error());
  const auto leaves = withInstantActions(given);
  setKinds(*tree, leaves);
  std::set<std::string> instant;
  findInstant(*tree, leaves, instant);
  Vocabulary vocabulary(leaves, folder);
  vocabulary.undeclared = forest->undeclared;
  const auto main = Composites(vocabulary).of(missionOf(*forest, std::move(*tree)));
  if (!vocabulary.errors.empty()) return std::unexpected(std::move(vocabulary.errors));
  vocabulary.properties.push_back(endProperty(vocabulary, main));
  const auto program = simplified(vocabulary.program(), main);
  remarkUnticked(vocabulary, program);
  const auto head = fmt::format("The behavior tree `{}` of {}, by `proskill import bt`.", main,
                                root.filename().generic_string());
  return Imported{write(head, program), vocabulary.notes.empty(),
                  summaryOf(vocabulary, *forest, instant)};
}

} // namespace proskill::bridge::bt
