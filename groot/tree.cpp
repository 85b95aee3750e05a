#include "groot/tree.h"

#include "analysis/names/call_graph.h"

#include <limits>
#include <set>

namespace proskill::groot {

namespace {

constexpr std::size_t kMostNodes = std::numeric_limits<Uid>::max();

/// The skills that no skill calls and that are executed: the mission and the monitors, or the
/// skills of a library.
std::vector<std::string> rootsOf(const analysis::Program& program, const std::string& mission) {
  const auto& skills = program.skills.all;
  const analysis::CallGraph calls(program);
  std::set<std::size_t> called;
  for (std::size_t i = 0; i < skills.size(); ++i)
    for (const auto& call : calls.from(i)) called.insert(call.callee);
  std::vector<std::string> roots;
  if (!mission.empty()) roots.push_back(mission);
  for (std::size_t i = 0; i < skills.size(); ++i)
    if (skills[i]->isComposite() && !called.contains(i) && skills[i].name() != mission &&
        (mission.empty() || skills[i]->monitor))
      roots.emplace_back(skills[i].name());
  return roots;
}

class Expansion {
public:
  explicit Expansion(const analysis::Program& of) : program(of) {}

  std::expected<Tree, std::string> from(const std::vector<std::string>& roots) {
    const bool isOne = roots.size() == 1;
    tree.blocks.push_back(isOne ? blockOf(program, *program.skills.find(roots.front()))
                                : blockOf(program, roots));
    if (isOne) known.emplace(roots.front(), 0);
    add({});
    for (std::uint32_t i = 0; i < tree.instances.size() && size <= kMostNodes; ++i) expand(i);
    if (size > kMostNodes)
      return std::unexpected("its tree has more than 65535 nodes, a node for each call of a skill");
    tree.mission = isOne ? 0 : 1;
    return std::move(tree);
  }

private:
  void add(Instance instance) {
    instance.first = static_cast<Uid>(size + 1);
    size += tree.blockOf(instance).nodes.size();
    tree.instances.push_back(std::move(instance));
  }

  void expand(std::uint32_t caller) {
    const auto block = tree.instances[caller].block;
    for (NodeIndex i = 0; i < tree.blocks[block].nodes.size() && size <= kMostNodes; ++i) {
      if (tree.blocks[block].nodes[i].kind != NodeKind::SubTree) continue;
      const auto skill = tree.blocks[block].nodes[i].skill;
      const auto& from = tree.instances[caller];
      auto path =
          from.path + (from.path.empty() ? "" : "/") + skill + "::" + std::to_string(from.uid(i));
      const auto callee = blockFor(skill);
      tree.below.emplace(std::pair(caller, i), tree.instances.size());
      add({.block = callee, .path = std::move(path), .parent = caller, .call = i});
    }
  }

  std::uint32_t blockFor(const std::string& skill) {
    const auto [found, isNew] =
        known.emplace(skill, static_cast<std::uint32_t>(tree.blocks.size()));
    if (isNew) tree.blocks.push_back(blockOf(program, *program.skills.find(skill)));
    return found->second;
  }

  const analysis::Program& program;
  Tree tree;
  std::map<std::string, std::uint32_t> known; ///< blocks by skill
  std::size_t size = 0;
};

} // namespace

std::size_t Tree::size() const {
  return instances.back().first + blockOf(instances.back()).nodes.size() - 1;
}

std::expected<Tree, std::string> treeOf(const analysis::Program& program,
                                        const runtime::Executable& executable) {
  const auto roots = rootsOf(program, executable.model.mainSkill);
  if (roots.empty()) return std::unexpected("no composite skill is executed");
  return Expansion(program).from(roots);
}

} // namespace proskill::groot
