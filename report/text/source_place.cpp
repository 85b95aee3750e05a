#include "report/text/source_place.h"

#include "report/text/text_width.h"
#include "syntax/text/utf8.h"

#include <algorithm>

namespace proskill::report {

SourcePlace SourcePlaces::at(syntax::FileId file, syntax::Offset offset) {
  const auto& document = program.files[file].document;
  const std::string_view text = document.text();
  offset = std::min(offset, static_cast<syntax::Offset>(text.size()));
  const auto position = document.lines().position(offset);
  const bool continues = file == lastFile && position.line + 1 == last.line && lastOffset <= offset;
  if (!continues) {
    lastOffset = offset - position.column;
    last = {position.line + 1, 1};
  }
  lastFile = file;
  while (lastOffset < offset) {
    const std::size_t length = syntax::characterLength(text.substr(lastOffset));
    if (lastOffset + length > offset) break;
    lastOffset += static_cast<syntax::Offset>(length);
    ++last.column;
  }
  return last;
}

} // namespace proskill::report
