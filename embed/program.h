#pragma once

#include "analysis/program/program.h"
#include "embed/failure.h"

#include <memory>

/// What programs in C see as proskill_program.
struct proskill_program {
  std::shared_ptr<const proskill::analysis::Program> program;
};

namespace proskill::embed {

/// Loads a program without errors.
[[nodiscard]] std::expected<proskill_program, Failure> loadProgram(const char* file);

/// A place for users: line and column from 1, the column in characters.
struct Place {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};
[[nodiscard]] Place placeOf(const analysis::Program& program, const analysis::Location& location);

/// `FILE:LINE:COLUMN: error: MESSAGE`
[[nodiscard]] std::string errorAt(const analysis::Program& program,
                                  const analysis::Location& location, std::string_view message);

} // namespace proskill::embed
