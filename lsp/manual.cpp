#include "lsp/manual.h"

#include "lsp/uri.h"

#include <fmt/format.h>

#include <fstream>

namespace proskill::lsp {

Manual::Manual(std::filesystem::path file) : page(std::move(file)) {
  constexpr std::string_view kHeading = "## ";
  std::ifstream stream(page);
  unsigned number = 1;
  for (std::string line; std::getline(stream, line); ++number)
    if (line.starts_with(kHeading))
      lines.emplace(line.substr(kHeading.size(), line.find(':') - kHeading.size()), number);
}

std::string Manual::linkTo(std::string_view code) const {
  const auto found = lines.find(code);
  return found == lines.end() ? std::string() : fmt::format("{}#L{}", toUri(page), found->second);
}

} // namespace proskill::lsp
