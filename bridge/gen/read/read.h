#pragma once

#include "analysis/program/program.h"
#include "bridge/gen/read/parser.h"

namespace proskill::bridge::gen {

struct Components {
  std::vector<Component> all; ///< with the services of the interfaces that they provide
  std::vector<Word> ignored;  ///< directives of the preprocessor that matter
  std::vector<Word> missing;  ///< includes that cannot be read, often of installed interfaces
};

/// The components of a file and of those that it includes, checked as GenoM3 does: each state has
/// one codel, and each name of a service, a state or an exception is declared.
[[nodiscard]] std::expected<Components, Errors> read(const analysis::FileSystem& files,
                                                     const std::filesystem::path& root);

} // namespace proskill::bridge::gen
