#include "bridge/bt/read/read_nodes.h"

#include "bridge/bt/read/script.h"
#include "syntax/diagnostics/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

namespace proskill::bridge::bt {
namespace {

bool nameIsNeeded(std::string_view tag) {
  return tag == "Action" || tag == "Condition" || tag.starts_with("SubTree");
}

/// Attributes that BehaviorTree.CPP itself reads of a node, as scripts.
constexpr auto kScripts =
    std::to_array<std::string_view>({"_failureIf", "_successIf", "_skipIf", "_while", "_onSuccess",
                                     "_onFailure", "_onHalted", "_post"});
/// What else it reads itself; all other names are ports.
constexpr auto kReserved =
    std::to_array<std::string_view>({"_autoremap", "_description", "_fullpath", "_uid"});

bool isAmong(std::span<const std::string_view> names, std::string_view key) {
  return std::ranges::find(names, key) != names.end();
}

/// Ports without which BehaviorTree.CPP does not execute a node.
struct Needed {
  std::string_view type;
  const char* port;
};
constexpr auto kNeeded = std::to_array<Needed>({{"SetBlackboard", "output_key"},
                                                {"SetBlackboard", "value"},
                                                {"UnsetBlackboard", "key"},
                                                {"Script", "code"},
                                                {"ScriptCondition", "code"},
                                                {"Precondition", "if"},
                                                {"WasEntryUpdated", "entry"},
                                                {"SkipUnlessUpdated", "entry"},
                                                {"WaitValueUpdate", "entry"}});

/// Attributes of subtrees in version 3: both let a subtree use the entries outside.
bool isOfVersion3(std::string_view key) {
  return key == "__shared_blackboard" || key == "__autoremap";
}

/// The type of a node: the name of its element, or its `ID` in the explicit form. Actions and
/// conditions have one of their own there, unless it is of a node that is built in.
const std::string& tag(const Element& element) {
  const auto* id = element.attribute("ID");
  if (id == nullptr) return element.name;
  if (element.name == "Control" || element.name == "Decorator") return *id;
  const bool isLeaf = element.name == "Action" || element.name == "Condition";
  const auto* known = isLeaf ? builtIn(*id) : nullptr;
  // BehaviorTree.CPP does not contain the conditions of Nav2: an action may have such a name.
  const bool isOfOthers = known != nullptr && known->kind == Kind::Condition &&
                          *id != "ScriptCondition" && *id != "WasEntryUpdated";
  return known != nullptr && !isOfOthers ? *id : element.name;
}

/// Why a control node or a decorator cannot be read as any one of its author; null: it can.
const char* notSupported(std::string_view type) {
  if (type == "FallbackStar" || type == "ParallelNode")
    return "it is a node of version 2, in which a `Sequence` is what a `ReactiveSequence` is now";
  if (type == "PathLongerOnApproach") return "it ends without halting its child";
  return nullptr;
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
  defaultPorts(node);
  for (const auto& child : element.children) node.children.push_back(this->node(child));
  return node;
}

void NodeReader::attributes(const Element& element, Node& node) {
  for (const auto& [key, value] : element.attributes) {
    const bool isScript = isAmong(kScripts, key);
    if (isScript && !value.empty()) script(element, value);
    if (tag(element).starts_with("SubTree") && isOfVersion3(key))
      node.ports.emplace(key.substr(1), value);
    else if (key.starts_with('_') && !isScript && !isAmong(kReserved, key))
      withoutEffect(element, key);
    else if (key == "ID")
      node.id = value;
    else if (key == "name")
      node.name = value;
    else if (key != "_fullpath" && key != "_uid")
      node.ports.emplace(key, value);
  }
}

/// BehaviorTree.CPP ignores such attributes. Editors of trees use some; others are typing errors.
void NodeReader::withoutEffect(const Element& element, const std::string& key) {
  const auto message = fmt::format("`{}` is not an attribute of BehaviorTree.CPP", key);
  if (const auto meant = syntax::nearest(key, kScripts); !meant.empty())
    return fail(element, fmt::format("{}; did you mean `{}`?", message, meant));
  if (forest.ignored.insert(key).second)
    forest.notes.push_back({element.place, message + ", and has no effect"});
}

void NodeReader::classify(const Element& element, Node& node) {
  const auto* known = builtIn(tag(element));
  if (known == nullptr) return classifyCustom(element, node);
  node.kind = known->kind;
  needed(element);
  countChildren(element, known->least, known->most);
  if (nameIsNeeded(tag(element)) && node.id.empty())
    fail(element, fmt::format("`{}` needs an attribute `ID`", tag(element)));
  if (!nameIsNeeded(tag(element))) node.id = tag(element);
}

void NodeReader::needed(const Element& element) {
  for (const auto& [type, port] : kNeeded)
    if (tag(element) == type && element.attribute(port) == nullptr)
      fail(element, fmt::format("`{}` needs an attribute `{}`", type, port));
  for (const auto* port : {"code", "if"})
    if (const auto* script = element.attribute(port); script && !script->starts_with('{'))
      this->script(element, *script);
}

void NodeReader::script(const Element& element, const std::string& code) {
  if (const auto why = scriptError(code))
    fail(element, fmt::format("this is not a script: {}", *why));
}

void NodeReader::classifyCustom(const Element& element, Node& node) {
  node.id = tag(element);
  if (const auto declared = forest.declared.find(node.id); declared != forest.declared.end()) {
    node.kind = declared->second;
    undeclaredPorts(node);
    return countChildren(element, 0, 0);
  }
  if (forest.trees.contains(node.id)) {
    node.kind = Kind::SubTree;
    return countChildren(element, 0, 0);
  }
  if (const auto* why = notSupported(node.id))
    return fail(element, fmt::format("`{}` is not supported: {}", node.id, why));
  node.kind = element.children.empty() ? Kind::Action : Kind::Own;
  auto& names = element.children.empty() ? forest.undeclared : forest.own;
  if (std::ranges::find(names, node.id) == names.end()) names.push_back(node.id);
}

/// A model without any port is one that nobody has completed.
void NodeReader::undeclaredPorts(const Node& node) {
  const auto known = forest.ports.find(node.id);
  if (known == forest.ports.end()) return;
  for (const auto& [port, value] : node.ports)
    if (!port.starts_with('_') && !known->second.contains(port))
      forest.notes.push_back(
          {node.place, fmt::format("`{}` is not a port that `TreeNodesModel` declares for `{}`",
                                   port, node.id)});
}

void NodeReader::defaultPorts(Node& node) {
  const bool isLeaf = node.kind == Kind::Action || node.kind == Kind::Condition;
  const bool isTree = node.kind == Kind::SubTree && !isTrue(node.port("_autoremap"));
  const auto known = forest.ports.find(node.id);
  if (known == forest.ports.end() || (!isLeaf && !isTree)) return;
  for (const auto& [name, model] : known->second)
    if (!node.ports.contains(name)) defaultPort(node, name, model);
}

void NodeReader::defaultPort(Node& node, const std::string& name, const PortModel& model) {
  const bool isTree = node.kind == Kind::SubTree;
  if (isTree && model.byDefault.empty() && forest.hasFormat)
    return errors.push_back(
        {node.place, fmt::format("`{}` needs a value for its port `{}`: `TreeNodesModel` declares "
                                 "it without a default",
                                 node.id, name)});
  // An output needs an entry of the blackboard.
  if (!model.byDefault.empty() && (isTree || model.isInput || isEntry(model.byDefault)))
    node.ports.emplace(name, model.byDefault);
}

void NodeReader::countChildren(const Element& element, std::size_t least, std::size_t most) {
  const auto count = element.children.size();
  if (count >= least && count <= most) return;
  fail(element,
       fmt::format("`{}` must have {}, not {}", tag(element), expected(least, most), count));
}

void NodeReader::fail(const Element& element, std::string message) {
  errors.push_back({element.place, std::move(message)});
}

} // namespace proskill::bridge::bt
