#include "cli/bridges/own_definitions.h"

#include "syntax/document.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace proskill::cli {
namespace {

constexpr std::array<std::string_view, 5> kNeverImported{"defproperty", "defenvironment",
                                                         "defplatform", "defconst", "include"};

/// The property that `import bt` writes.
bool isOfImport(std::string_view name) { return name.ends_with("_can_end"); }

} // namespace

std::vector<std::string> ownDefinitions(std::string_view existing, std::string_view imported) {
  std::vector<std::string> own;
  const auto document = syntax::Document::parse(std::string(existing));
  for (const auto& form : document.forms()) {
    const auto text = document.text().substr(form.range.begin, form.range.length());
    const auto kind = std::ranges::find_if(kNeverImported, [&](std::string_view keyword) {
      return text.starts_with(fmt::format("({} ", keyword));
    });
    if (kind == kNeverImported.end() || isOfImport(form.name.text)) continue;
    if (imported.find(text) == std::string_view::npos)
      own.push_back(form.name.text.empty() ? std::string(text)
                                           : fmt::format("{} {}", *kind, form.name.text));
  }
  return own;
}

} // namespace proskill::cli
