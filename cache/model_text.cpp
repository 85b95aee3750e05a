#include "cache/model_text.h"

#include "fiacre/print/print.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::cache {

namespace {

/// The text without comments, which contain the provenance.
std::string withoutComments(std::string_view text) {
  std::string kept;
  while (!text.empty()) {
    const auto line = text.substr(0, text.find('\n'));
    kept.append(line.substr(0, line.find("//"))).append("\n");
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return kept;
}

} // namespace

std::string textOf(fiacre::Program program) {
  std::erase_if(program.properties, [](const auto& property) { return property.asserted; });
  return withoutComments(fiacre::print(program));
}

std::string textOf(const fiacre::Pattern& pattern, const std::string& main) {
  return fmt::format("{} {}", static_cast<int>(pattern.kind), fiacre::printPattern(pattern, main));
}

} // namespace proskill::cache
