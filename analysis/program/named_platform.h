#pragma once

#include "analysis/program/program.h"

#include <filesystem>
#include <optional>
#include <string>

namespace proskill::analysis {

/// The file that a program's `defplatform` names.
struct NamedPlatform {
  std::string written;        ///< its path as the clause has it
  std::filesystem::path file; ///< resolved against the file with the clause
  Location at;                ///< its path in the clause
};

/// Nothing if the program names none. The file need not exist.
[[nodiscard]] std::optional<NamedPlatform> namedPlatform(const Program& program);

} // namespace proskill::analysis
