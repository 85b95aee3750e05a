#pragma once

#include "bridge/bt/read/xml.h"
#include "bridge/bt/tree/tree.h"

namespace proskill::bridge::bt {

/// Reads elements of a `BehaviorTree` as nodes.
class NodeReader {
public:
  NodeReader(Forest& forest, Errors& errors) : forest(forest), errors(errors) {}

  /// The node of an element, with its children. Errors are added to the list.
  Node node(const Element& element);

private:
  void attributes(const Element& element, Node& node);
  void withoutEffect(const Element& element, const std::string& key);
  void classify(const Element& element, Node& node);
  void classifyCustom(const Element& element, Node& node);
  /// Attributes that a node of BehaviorTree.CPP cannot do without.
  void needed(const Element& element);
  void script(const Element& element, const std::string& code);
  void undeclaredPorts(const Node& node);
  /// Adds the ports that have a value in `TreeNodesModel` and none at the node.
  void defaultPorts(Node& node);
  void defaultPort(Node& node, const std::string& name, const PortModel& model);
  void countChildren(const Element& element, std::size_t least, std::size_t most);
  void fail(const Element& element, std::string message);

  Forest& forest;
  Errors& errors;
};

} // namespace proskill::bridge::bt
