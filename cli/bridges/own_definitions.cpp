#include "cli/bridges/own_definitions.h"

#include "syntax/document.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace proskill::cli {
namespace {

constexpr std::array<std::string_view, 5> kNeverImported{"defproperty", "defenvironment",
                                                         "defplatform", "defconst", "include"};

/// Whether it is the property that `import bt` writes about its main skill.
bool isOfImport(std::string_view property, std::string_view name) {
  constexpr std::string_view kEnd = "_can_end";
  if (!name.ends_with(kEnd)) return false;
  const auto main = name.substr(0, name.size() - kEnd.size());
  return property.ends_with(fmt::format("(reachable (ended {})))", main));
}

} // namespace

std::vector<std::string> ownDefinitions(std::string_view existing, std::string_view imported) {
  std::vector<std::string> own;
  const auto document = syntax::Document::parse(std::string(existing));
  for (const auto& form : document.forms()) {
    const auto text = document.text().substr(form.range.begin, form.range.length());
    const auto [keyword, name] = std::pair(form.keyword.text, form.name.text);
    if (std::ranges::find(kNeverImported, keyword) == kNeverImported.end()) continue;
    if (isOfImport(text, name) || imported.find(text) != std::string_view::npos) continue;
    own.push_back(name.empty() ? std::string(text) : fmt::format("{} {}", keyword, name));
  }
  return own;
}

} // namespace proskill::cli
