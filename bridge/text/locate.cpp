#include "bridge/text/locate.h"

namespace proskill::bridge {

Place placeOf(const analysis::Program& program, analysis::Location location) {
  const auto& file = program.files[location.file];
  const auto at = file.document.lines().position(location.range.begin);
  return {file.path, at.line + 1, at.column + 1};
}

} // namespace proskill::bridge
