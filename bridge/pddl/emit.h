#pragma once

#include "analysis/program/program.h"
#include "bridge/text/emitted.h"

#include <expected>

/// Programs as planning problems in PDDL 2.1.
/// M. Fox, D. Long, "PDDL2.1: an extension to PDDL for expressing temporal planning domains", 2003.
namespace proskill::bridge::pddl {

/// How the outcomes of skills are treated.
enum class Outcomes : std::uint8_t {
  Best, ///< a skill succeeds
  All,  ///< a planner chooses any outcome, also a failure
};

/// The basic skills of a program as durative actions, one for each outcome and for each choice of
/// values of the inputs that its conditions and effects read, and its events as instantaneous
/// actions. A comment above each action names the skill with its outcome, `only` if it has no
/// other, and its inputs, `input=value` or `input:type`, or the event; comments also name
/// environments, and say what predicates and functions stand for.
/// \return the domain, or the parts without which a plan would mean something else: conditions
/// about skills, effects that copy a variable, and inputs that are read and have too many values
[[nodiscard]] std::expected<Emitted, Errors> emitDomain(const analysis::Program& program,
                                                        const std::string& name, Outcomes outcomes);

/// The initial values of a program, and a goal.
/// \param goal a condition of the program
[[nodiscard]] std::expected<Emitted, Errors> emitProblem(const analysis::Program& program,
                                                         const std::string& name,
                                                         const syntax::Expr& goal,
                                                         analysis::FileId file);

} // namespace proskill::bridge::pddl
