#include "bridge/bt/guard.h"

#include <algorithm>

namespace proskill::bridge::bt {

Form Guard::of(const Node& node, bool negated) {
  const auto& children = node.children;
  switch (node.kind) {
  case Kind::Condition: return leaf(node, negated);
  case Kind::Sequence:
  case Kind::ReactiveSequence: return joinedChildren(node, children.size(), true, negated);
  case Kind::Fallback:
  case Kind::ReactiveFallback: return joinedChildren(node, children.size(), false, negated);
  case Kind::IfThenElse: return choice(node, negated);
  case Kind::Inverter: return of(children.front(), !negated);
  case Kind::SubTree: return of(children.front(), negated);
  case Kind::AlwaysFailure:
  case Kind::ForceFailure: return negated ? "true" : "false";
  default: return negated ? "false" : "true"; // the other pure ones succeed
  }
}

Form Guard::ofAll(const Node& node, std::size_t count, bool negatedEach, bool negatedAll) {
  std::vector<Form> parts;
  for (std::size_t i = 0; i < count; ++i)
    parts.push_back(of(node.children[i], negatedEach != negatedAll));
  return joined(negatedAll ? "or" : "and", parts);
}

Form Guard::leaf(const Node& node, bool negated) {
  const auto ends = vocabulary.traits.ends(node);
  if (!ends.failure) return negated ? "false" : "true";
  if (!ends.success) return negated ? "true" : "false";
  auto& variable = variables[&node];
  if (variable.empty()) variable = vocabulary.watched(node);
  return list(variable, negated ? "No" : "Yes");
}

Form Guard::joined(const char* word, const std::vector<Form>& parts) {
  const Form neutral = word == std::string_view("and") ? "true" : "false";
  const Form deciding = word == std::string_view("and") ? "false" : "true";
  Form result = list(word);
  for (const auto& part : parts) {
    if (part == deciding) return deciding;
    if (part != neutral) result.parts.push_back(part);
  }
  if (result.parts.size() == 1) return neutral;
  return result.parts.size() == 2 ? result.parts.back() : result;
}

Form Guard::joinedChildren(const Node& node, std::size_t count, bool isAnd, bool negated) {
  std::vector<Form> parts;
  for (std::size_t i = 0; i < count; ++i) parts.push_back(of(node.children[i], negated));
  return joined(isAnd != negated ? "and" : "or", parts);
}

Form Guard::choice(const Node& node, bool negated) {
  if (choices == kMostChoices) return "true"; // after an error
  if (++choices == kMostChoices)
    vocabulary.fail(node, "conditions with so many `IfThenElse` in each other are not supported");
  const auto& children = node.children;
  const Form yes = joined("and", {of(children[0], false), of(children[1], negated)});
  const Form otherwise = children.size() > 2 ? of(children[2], negated)
                         : negated           ? Form("true")
                                             : Form("false");
  return joined("or", {yes, joined("and", {of(children[0], true), otherwise})});
}

} // namespace proskill::bridge::bt
