#pragma once

#include "analysis/flow/inspect.h"
#include "analysis/program/named_platform.h"
#include "codegen/model.h"
#include "runtime/platform/file_error.h"
#include "syntax/diagnostics/diagnostic.h"

#include <expected>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Checks platform files without running anything: of the program that performs the actions, and of
/// the library that does, only the file's own text is read.
namespace proskill::runtime {

struct PlatformCheck {
  FileErrors errors; ///< as `proskill run` reports them
  /// Events of the program that the platform never reports, as far as its file shows.
  std::vector<std::string> silentEvents;
};

/// \param interface null: only what needs no program is checked
[[nodiscard]] PlatformCheck checkPlatform(std::string_view text, const analysis::Program& program,
                                          const codegen::PlatformInterface* interface);

/// A diagnostic about the platform that a program names.
struct PlatformFinding {
  syntax::Diagnostic diagnostic; ///< at the path in the program
  std::filesystem::path file;
  std::string why;                  ///< for readers of that file
  std::optional<FilePlace> place{}; ///< in that file
};

using ReadFile =
    std::function<std::expected<std::string, std::string>(const std::filesystem::path&)>;

/// Checks the platform file that a program names.
/// \param isSound whether the program is whole and has no errors; otherwise the file is checked by
/// itself
/// \param settings severities of warnings; errors keep theirs
[[nodiscard]] std::vector<PlatformFinding>
checkNamedPlatform(const analysis::Program& program, bool isSound,
                   const analysis::flow::Settings& settings, const ReadFile& read);

} // namespace proskill::runtime
