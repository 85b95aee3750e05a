#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace proskill::test {

struct Judged {
  bool decided = false;       ///< the program has no errors and is small enough for the engine
  std::size_t impossible = 0; ///< claims of "never" that the engine has looked at
  std::size_t certain = 0;    ///< claims of "always" whose place the engine has reached
  std::map<std::string, std::size_t> codes; ///< how often each diagnostic was said
  std::vector<std::string> refuted;
};

/// Puts the claims of the flow analysis before the engine: what it says can never happen must not
/// be found, what it says is certain must.
[[nodiscard]] Judged judge(const std::string& program);

} // namespace proskill::test
