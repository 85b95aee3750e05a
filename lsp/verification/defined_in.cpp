#include "lsp/verification/defined_in.h"

#include <algorithm>

namespace proskill::lsp {

std::vector<std::string> definedIn(const analysis::Program& program,
                                   const std::filesystem::path& path, std::uint32_t first,
                                   std::uint32_t last) {
  std::vector<std::string> names;
  const auto file = std::ranges::find(program.files, path, &analysis::File::path);
  if (file == program.files.end()) return names;
  const auto& index = file->document.lines();
  const syntax::Range range{index.offset({first, 0}), index.offset({last + 1, 0})};
  const auto add = [&](const auto& table) {
    for (const auto& each : table.all) {
      const auto at = each.form->range;
      if (program.files[each.file].path == path && at.begin < range.end && range.begin < at.end)
        names.emplace_back(each.name());
    }
  };
  add(program.stateVariables);
  add(program.skills);
  add(program.properties);
  return names;
}

} // namespace proskill::lsp
