#include "syntax/text/edit.h"

namespace proskill::syntax {

std::string applyEdits(std::string_view text, std::span<const TextEdit> edits) {
  std::string result;
  result.reserve(text.size());
  Offset done = 0;
  for (const TextEdit& edit : edits) {
    result += text.substr(done, edit.range.begin - done);
    result += edit.text;
    done = edit.range.end;
  }
  return result += text.substr(done);
}

} // namespace proskill::syntax
