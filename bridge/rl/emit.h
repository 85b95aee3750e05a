#pragma once

#include "analysis/program/program.h"
#include "bridge/text/emitted.h"

#include <expected>

namespace proskill::bridge::rl {

/// A program as a skillset: its enumerations, events and basic skills. Composite skills, times,
/// environments and properties have no equivalent; they are noted and omitted.
/// \param name of the skillset
/// \return the text, or the parts without which it would mean something else: numbers, resources,
/// and conditions about skills
[[nodiscard]] std::expected<Emitted, Errors> emitSkillset(const analysis::Program& program,
                                                          const std::string& name);

} // namespace proskill::bridge::rl
