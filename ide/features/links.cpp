#include "ide/features/structure.h"

namespace proskill::ide {

std::vector<DocumentLink> links(const std::filesystem::path& file,
                                const syntax::Document& document) {
  std::vector<DocumentLink> result;
  const auto add = [&](const syntax::Name& path) {
    if (path) result.push_back({path.range, (file.parent_path() / path.text).lexically_normal()});
  };
  for (const auto& form : document.forms()) {
    if (const auto* include = form.as<syntax::Include>()) add(include->path);
    if (const auto* platform = form.as<syntax::Platform>()) add(platform->path);
  }
  return result;
}

} // namespace proskill::ide
