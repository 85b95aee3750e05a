#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proskill::bridge::bt {

/// A text as BehaviorTree.CPP reads it, in well-formed XML.
struct RepairedXml {
  std::string text;
  /// Bytes in `text` that the original does not have, in order.
  std::vector<std::size_t> added;
};

/// BehaviorTree.CPP (tinyxml2) reads `&` and `<` in attributes, `--` in comments, and white space
/// before the declaration. XML has other ways to write them.
[[nodiscard]] RepairedXml repairXml(std::string_view text);

} // namespace proskill::bridge::bt
