#include "bridge/bt/emit/elements.h"
#include "groot/tree.h"

#include <set>

namespace proskill::groot {

namespace {

using bridge::bt::Element;

/// The node and its descendants. \param next is set to the node after them
Element elementOf(const Tree& tree, std::uint32_t id, NodeIndex& next) {
  const auto& instance = tree.instances[id];
  const auto& node = tree.blockOf(instance).nodes[next];
  auto element = bridge::bt::element(node.tag, node.attributes);
  if (const auto below = tree.below.find({id, next}); below != tree.below.end())
    element.attributes.emplace_back("_fullpath", tree.instances[below->second].path);
  else if (!element.attribute("name"))
    element.attributes.emplace(element.attributes.begin(), "name", node.tag);
  element.attributes.emplace_back("_uid", std::to_string(instance.uid(next)));
  for (++next; next < node.end;) element.children.push_back(elementOf(tree, id, next));
  return element;
}

std::string_view modelOf(NodeKind kind, const std::string& tag) {
  switch (kind) {
  case NodeKind::Control:
  case NodeKind::Parallel: return tag == "Case" || tag == "Choose" ? "Control" : "";
  case NodeKind::Test: return "Condition";
  case NodeKind::SubTree:
  case NodeKind::Choice:
  case NodeKind::Loop: return "";
  case NodeKind::Call:
  case NodeKind::Leaf:
  case NodeKind::Timed:
  case NodeKind::Failing: return tag == "AlwaysSuccess" ? "" : "Action";
  }
  return "";
}

/// The nodes that are not built in, with their ports.
Element modelsOf(const Tree& tree) {
  std::map<std::string, std::pair<std::string_view, std::set<std::string>>> models;
  for (const auto& block : tree.blocks)
    for (const auto& node : block.nodes) {
      const auto kind = modelOf(node.kind, node.tag);
      if (kind.empty()) continue;
      auto& [as, ports] = models[node.tag];
      as = kind;
      for (const auto& [port, value] : node.attributes) ports.insert(port);
    }
  auto all = bridge::bt::element("TreeNodesModel");
  for (const auto& [id, model] : models) {
    auto& element =
        all.children.emplace_back(bridge::bt::element(std::string(model.first), {{"ID", id}}));
    for (const auto& port : model.second)
      element.children.push_back(bridge::bt::element("input_port", {{"name", port}}));
  }
  return all;
}

} // namespace

std::string xmlOf(const Tree& tree) {
  auto root =
      bridge::bt::element("root", {{"BTCPP_format", "4"}, {"main_tree_to_execute", tree.name()}});
  for (std::uint32_t i = 0; i < tree.instances.size(); ++i) {
    const auto& instance = tree.instances[i];
    NodeIndex first = 0;
    root.children.push_back(bridge::bt::element(
        "BehaviorTree", {{"ID", tree.blockOf(instance).name}, {"_fullpath", instance.path}},
        {elementOf(tree, i, first)}));
  }
  root.children.push_back(modelsOf(tree));
  return bridge::bt::writeXml(root);
}

} // namespace proskill::groot
