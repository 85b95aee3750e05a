#pragma once

#include "fiacre/syntax/tree.h"

#include <string>
#include <vector>

namespace proskill::fiacre {

/// A port on which no two instances ever synchronise. Each instance passes it alone, so it never
/// makes one wait, and may hide that other instances have stopped.
struct LonePort {
  std::string component; ///< the component that declares it
  std::string port;
  /// The process of the only instance that has it; empty: several instances have it.
  std::string only;
  friend bool operator==(const LonePort&, const LonePort&) = default;
};

/// In the order of the text. Ports with an interval, a priority or a probe are omitted, because a
/// single instance may need them.
/// \pre check() finds no problem in the program
[[nodiscard]] std::vector<LonePort> lonePorts(const Program& program);

} // namespace proskill::fiacre
