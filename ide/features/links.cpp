#include "ide/features/structure.h"

namespace proskill::ide {

std::vector<DocumentLink> links(const std::filesystem::path& file,
                                const syntax::Document& document) {
  std::vector<DocumentLink> result;
  for (const auto& form : document.forms())
    if (const auto* include = form.as<syntax::Include>(); include && include->path)
      result.push_back(
          {include->path.range, (file.parent_path() / include->path.text).lexically_normal()});
  return result;
}

} // namespace proskill::ide
