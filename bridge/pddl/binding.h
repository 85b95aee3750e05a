#pragma once

#include "analysis/program/program.h"

#include <expected>
#include <map>
#include <string>
#include <vector>

namespace proskill::bridge::pddl {

/// A value for each input of a skill that its conditions or effects read, by its name with `$`.
using Binding = std::map<std::string_view, syntax::Expr>;

/// A name without `$`.
[[nodiscard]] inline std::string_view bare(std::string_view input) { return input.substr(1); }

/// The bindings of a basic skill, for which PDDL has an action each. One that binds nothing, if the
/// skill reads no input.
/// \return or why there is not a limited number: the type of an input has infinitely many values,
/// or there are more than 1,000 bindings
[[nodiscard]] std::expected<std::vector<Binding>, std::string>
bindingsOf(const analysis::Program& program, const syntax::Skill& skill);

} // namespace proskill::bridge::pddl
