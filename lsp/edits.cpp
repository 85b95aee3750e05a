#include "lsp/edits.h"

namespace proskill::lsp {

Json textEdits(const Converter& convert, analysis::FileId file,
               std::span<const syntax::TextEdit> edits) {
  Json result = Json::array();
  for (const auto& edit : edits)
    result.push_back({{"range", convert.range(file, edit.range)}, {"newText", edit.text}});
  return result;
}

} // namespace proskill::lsp
