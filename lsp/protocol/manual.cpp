#include "lsp/protocol/manual.h"

#include "report/uri.h"

#include <fmt/format.h>

#include <fstream>

namespace proskill::lsp {

Manual::Manual(const std::filesystem::path& page) : uri(report::toUri(page)) {
  constexpr std::string_view kHeading = "## ";
  std::ifstream stream(page);
  unsigned number = 1;
  for (std::string line; std::getline(stream, line); ++number)
    if (line.starts_with(kHeading))
      lines.emplace(line.substr(kHeading.size(), line.find(':') - kHeading.size()), number);
}

std::string Manual::linkTo(std::string_view code) const {
  const auto found = lines.find(code);
  return found == lines.end() ? std::string() : fmt::format("{}#L{}", uri, found->second);
}

} // namespace proskill::lsp
