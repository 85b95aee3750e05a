#pragma once

#include <set>
#include <string>
#include <string_view>

namespace proskill::verify {

/// Makes identifiers of names, all different.
class Identifiers {
public:
  /// The prefix and the name, with `_` for what is neither a letter nor a digit.
  [[nodiscard]] std::string make(std::string_view prefix, std::string_view name);

private:
  std::set<std::string> taken;
};

} // namespace proskill::verify
