#include "analysis/program/named_platform.h"

namespace proskill::analysis {

std::optional<NamedPlatform> namedPlatform(const Program& program) {
  if (program.platforms.all.empty()) return std::nullopt;
  const auto& clause = program.platforms.all.front();
  const auto& path = clause->path;
  if (!path) return std::nullopt;
  const auto folder = program.files[clause.file].path.parent_path();
  return NamedPlatform{std::string(path.text), (folder / path.text).lexically_normal(),
                       clause.at(path.range)};
}

} // namespace proskill::analysis
