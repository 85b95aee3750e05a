#pragma once

#include "fiacre/syntax/tree.h"

#include <set>
#include <string>
#include <string_view>

namespace proskill::codegen {

/// Whether the expression names the variable.
[[nodiscard]] bool mentions(const fiacre::Expr& expr, std::string_view variable);

/// The names that the statements of a process use: variables, constants and constructors together,
/// and ports.
struct Mentioned {
  std::set<std::string, std::less<>> names;
  std::set<std::string, std::less<>> ports;
};
[[nodiscard]] Mentioned mentionedIn(const fiacre::Process& process);

} // namespace proskill::codegen
