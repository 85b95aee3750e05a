#include "bridge/bt/emit/elements.h"

#include "syntax/text/xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace proskill::bridge::bt {
namespace {

bool isConstant(const Element& element, bool succeeds) {
  return element.name == (succeeds ? "AlwaysSuccess" : "AlwaysFailure");
}

void addTo(Element& list, Element part) {
  if (part.name != list.name) return list.children.push_back(std::move(part));
  std::ranges::move(part.children, std::back_inserter(list.children));
}

void write(const Element& element, std::size_t depth, std::string& text) {
  const std::string indent(2 * depth, ' ');
  text += fmt::format("{}<{}", indent, element.name);
  for (const auto& [key, value] : element.attributes)
    text += fmt::format(" {}=\"{}\"", key, syntax::xmlAttribute(value));
  if (element.children.empty()) {
    text += "/>\n";
    return;
  }
  text += ">\n";
  for (const auto& child : element.children) write(child, depth + 1, text);
  text += fmt::format("{}</{}>\n", indent, element.name);
}

} // namespace

Element element(std::string name, Attributes attributes, std::vector<Element> children) {
  return {std::move(name), {}, std::move(attributes), std::move(children)};
}

Element constant(bool succeeds) { return element(succeeds ? "AlwaysSuccess" : "AlwaysFailure"); }

Element inOrder(bool isSequence, Element first, Element second) {
  if (isConstant(second, isSequence)) return first;
  if (isConstant(first, isSequence)) return second;
  const auto* name = isSequence ? "Sequence" : "Fallback";
  const bool isList = first.name == name;
  auto result = isList ? std::move(first) : element(name, {}, {std::move(first)});
  addTo(result, std::move(second));
  return result;
}

Element withResults(Element child, bool onSuccess, bool onFailure) {
  if (onSuccess && !onFailure) return child;
  if (onFailure && !onSuccess && child.name == "Inverter") return std::move(child.children.front());
  const auto* name = onSuccess ? "ForceSuccess" : onFailure ? "Inverter" : "ForceFailure";
  return element(name, {}, {std::move(child)});
}

Element decide(Element test, Element onSuccess, Element onFailure) {
  const auto isEither = [](const Element& part) {
    return isConstant(part, true) || isConstant(part, false);
  };
  if (isEither(onSuccess) && isEither(onFailure))
    return withResults(std::move(test), isConstant(onSuccess, true), isConstant(onFailure, true));
  if (isConstant(onFailure, false)) return inOrder(true, std::move(test), std::move(onSuccess));
  if (isConstant(onSuccess, true)) return inOrder(false, std::move(test), std::move(onFailure));
  if (isEither(onSuccess))
    return inOrder(true, withResults(std::move(test), false, true), std::move(onFailure));
  if (isEither(onFailure))
    return inOrder(false, withResults(std::move(test), false, true), std::move(onSuccess));
  return element("IfThenElse", {}, {std::move(test), std::move(onSuccess), std::move(onFailure)});
}

std::size_t depthOf(const Element& root) {
  std::size_t deepest = 0;
  for (const auto& child : root.children) deepest = std::max(deepest, depthOf(child));
  return deepest + 1;
}

std::string writeXml(const Element& root) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  write(root, 0, text);
  return text;
}

} // namespace proskill::bridge::bt
