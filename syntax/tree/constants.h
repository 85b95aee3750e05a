#pragma once

#include "syntax/tree/form.h"

#include <string_view>
#include <unordered_map>

namespace proskill::syntax {

/// The numbers that a program's constants stand for, by name.
using ConstantValues = std::unordered_map<std::string_view, const Expr*>;

/// The form with the numbers in place of the constants. They keep the constants' names and ranges.
/// A wait for a constant alone becomes a wait for that time.
/// \pre the text of the form outlives the result
[[nodiscard]] Form withConstants(const Form& form, const ConstantValues& values);

} // namespace proskill::syntax
