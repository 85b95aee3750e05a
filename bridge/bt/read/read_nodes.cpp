#include "bridge/bt/read/read_nodes.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::bridge::bt {
namespace {

bool nameIsNeeded(std::string_view tag) {
  return tag == "Action" || tag == "Condition" || tag.starts_with("SubTree");
}

std::string children(std::size_t count) {
  return fmt::format("{} child{}", count, count == 1 ? "" : "ren");
}

std::string expected(std::size_t least, std::size_t most) {
  if (least == most) return least == 0 ? "no children" : children(least);
  if (most == kAnyNumber) return "at least " + children(least);
  return fmt::format("{} to {}", least, children(most));
}

} // namespace

Node NodeReader::node(const Element& element) {
  Node node{.name = {}, .place = element.place};
  attributes(element, node);
  classify(element, node);
  for (const auto& child : element.children) node.children.push_back(this->node(child));
  return node;
}

void NodeReader::attributes(const Element& element, Node& node) {
  for (const auto& [key, value] : element.attributes) {
    if (key == "ID")
      node.id = value;
    else if (key == "name")
      node.name = value;
    else if (key != "_fullpath" && key != "_uid")
      node.ports.emplace(key, value);
  }
}

void NodeReader::classify(const Element& element, Node& node) {
  const auto* known = builtIn(element.name);
  if (known == nullptr) return classifyCustom(element, node);
  node.kind = known->kind;
  countChildren(element, known->least, known->most);
  if (nameIsNeeded(element.name) && node.id.empty())
    fail(element, fmt::format("`{}` needs an attribute `ID`", element.name));
  if (!nameIsNeeded(element.name)) node.id = element.name;
}

void NodeReader::classifyCustom(const Element& element, Node& node) {
  node.id = element.name;
  if (const auto declared = forest.declared.find(node.id); declared != forest.declared.end()) {
    node.kind = declared->second;
    return countChildren(element, 0, 0);
  }
  if (forest.trees.contains(node.id)) {
    node.kind = Kind::SubTree;
    return countChildren(element, 0, 0);
  }
  if (!element.children.empty())
    return fail(element, fmt::format("control node or decorator `{}` is not supported", node.id));
  node.kind = Kind::Action;
  if (std::ranges::find(forest.undeclared, node.id) == forest.undeclared.end())
    forest.undeclared.push_back(node.id);
}

void NodeReader::countChildren(const Element& element, std::size_t least, std::size_t most) {
  const auto count = element.children.size();
  if (count >= least && count <= most) return;
  fail(element,
       fmt::format("`{}` must have {}, not {}", element.name, expected(least, most), count));
}

void NodeReader::fail(const Element& element, std::string message) {
  errors.push_back({element.place, std::move(message)});
}

} // namespace proskill::bridge::bt
