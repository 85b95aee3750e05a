#pragma once

#include "bridge/bt/tree/tree.h"

#include <set>

namespace proskill::bridge::bt {

/// Names of ProSkill, each given once.
class NamePool {
public:
  /// The wish as a name, with a number at its end if it is taken.
  std::string take(std::string_view wish);
  /// The name that its author gave to a node, or else its type.
  std::string take(const Node& node) { return take(node.name.empty() ? node.id : node.name); }

private:
  std::set<std::string, std::less<>> taken;
  std::map<std::string, std::size_t, std::less<>> next;
};

/// Any text as a name of ProSkill.
[[nodiscard]] std::string asName(std::string_view text);
/// Any text as a string of ProSkill, with its quotes.
[[nodiscard]] std::string asString(std::string_view text);
/// A place as comments give it, `FILE:LINE:COLUMN`, the file relative to a folder.
[[nodiscard]] std::string asText(const Place& place, const std::filesystem::path& folder);
/// The line of a comment for a node: its place, its type, and its name.
[[nodiscard]] std::string asComment(const Node& node, const std::filesystem::path& folder);

} // namespace proskill::bridge::bt
