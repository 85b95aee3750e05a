#pragma once

#include "fiacre/syntax/tree.h"

#include <string>
#include <vector>

namespace proskill::fiacre {

/// A port that no two instances pass together: whoever can pass it does so alone, so that it never
/// holds anybody up, and may hide that the others have stopped.
struct LonePort {
  std::string component; ///< that declares it
  std::string port;
  std::string only; ///< the process of the only instance that has it; empty: several have it
  friend bool operator==(const LonePort&, const LonePort&) = default;
};

/// In the order of the text. A port with an interval or a priority of its own, or a probe, is what
/// one instance may well have for itself, and is none of them.
/// \pre check() finds nothing wrong with the program
[[nodiscard]] std::vector<LonePort> lonePorts(const Program& program);

} // namespace proskill::fiacre
