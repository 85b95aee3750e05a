#pragma once

#include "groot/block.h"
#include "runtime/machine/executable.h"

#include <expected>
#include <map>

namespace proskill::groot {

/// Identifies a node for viewers. The first one is 1.
using Uid = std::uint16_t;

inline constexpr std::uint32_t kNoInstance = UINT32_MAX;

/// A call of a composite skill, with nodes of its own.
struct Instance {
  std::uint32_t block = 0;
  std::string path; ///< `fetch::7/grasp::12`: the calls down to it; empty: the root
  Uid first = 1;    ///< of the block's first node; the others follow
  std::uint32_t parent = kNoInstance;
  NodeIndex call = 0; ///< in the parent's block

  [[nodiscard]] Uid uid(NodeIndex node) const { return static_cast<Uid>(first + node); }
};

/// The skills of a run as a behavior tree: the mission, or the mission beside the monitors.
struct Tree {
  std::vector<Block> blocks;       ///< callers come before those that only they call
  std::vector<Instance> instances; ///< the first is the root
  /// The instance below a call: by the caller and its node.
  std::map<std::pair<std::uint32_t, NodeIndex>, std::uint32_t> below;
  std::uint32_t mission = 0; ///< the instance whose result is the root's

  [[nodiscard]] std::size_t size() const; ///< number of nodes
  [[nodiscard]] const Block& blockOf(const Instance& instance) const {
    return blocks[instance.block];
  }
  [[nodiscard]] const std::string& name() const { return blocks.front().name; }
};

/// \return the tree, or why there is none
[[nodiscard]] std::expected<Tree, std::string> treeOf(const analysis::Program& program,
                                                      const runtime::Executable& executable);

/// The tree as BehaviorTree.CPP gives it to viewers: a `BehaviorTree` for each instance; nodes have
/// a `_uid`, instances a `_fullpath`.
[[nodiscard]] std::string xmlOf(const Tree& tree);

} // namespace proskill::groot
