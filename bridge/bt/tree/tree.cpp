#include "bridge/bt/tree/tree.h"

#include <algorithm>
#include <array>

namespace proskill::bridge::bt {
namespace {

constexpr auto kBuiltIn = std::to_array<BuiltIn>({
#define NODE(name, kind, least, most) {name, Kind::kind, least, most},
#include "bridge/bt/tree/nodes.def"
});

} // namespace

const BuiltIn* builtIn(std::string_view name) {
  const auto found = std::ranges::find(kBuiltIn, name, &BuiltIn::name);
  return found == kBuiltIn.end() ? nullptr : &*found;
}

bool isTrue(std::string_view value) {
  return value == "true" || value == "True" || value == "TRUE" || value == "1";
}

bool isEntry(std::string_view value) {
  if (value.starts_with("${")) value.remove_prefix(1);
  return value.size() > 2 && value.front() == '{' && value.back() == '}';
}

std::string Node::port(const std::string& called, std::string otherwise) const {
  const auto found = ports.find(called);
  return found == ports.end() ? std::move(otherwise) : found->second;
}

} // namespace proskill::bridge::bt
