#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace proskill::test {

struct Judged {
  bool decided = false;       ///< the program has no errors and is small enough for the engine
  std::size_t impossible = 0; ///< claims of "never" that the engine has checked
  std::size_t certain = 0;    ///< claims of "always" whose place the engine has reached
  std::map<std::string, std::size_t> codes; ///< how often each diagnostic was reported
  std::vector<std::string> refuted;
};

/// Checks the claims of the flow analysis with the engine: what it claims to be impossible must not
/// be found, what it claims to be certain must.
[[nodiscard]] Judged judge(const std::string& program);

} // namespace proskill::test
