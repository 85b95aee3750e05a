#include "syntax/text/utf8.h"

#include <utf8proc.h>

namespace proskill::syntax {

namespace {

struct Decoded {
  utf8proc_int32_t character = 0;
  utf8proc_ssize_t length = 0; ///< 0 for an empty text, negative if no character begins there
};

Decoded decode(std::string_view text) {
  Decoded made;
  made.length = utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                                 static_cast<utf8proc_ssize_t>(text.size()), &made.character);
  return made;
}

} // namespace

std::size_t sequenceLength(std::string_view text) {
  return static_cast<std::size_t>(std::max<utf8proc_ssize_t>(decode(text).length, 0));
}

std::optional<char32_t> firstCharacter(std::string_view text) {
  const auto [character, length] = decode(text);
  if (length <= 0) return std::nullopt;
  return static_cast<char32_t>(character);
}

std::optional<std::size_t> columnsOf(char32_t character) {
  const auto value = static_cast<utf8proc_int32_t>(character);
  const auto category = utf8proc_category(value);
  const bool isHidden = category == UTF8PROC_CATEGORY_CC || category == UTF8PROC_CATEGORY_CS ||
                        category == UTF8PROC_CATEGORY_CN;
  if (isHidden) return std::nullopt;
  return static_cast<std::size_t>(utf8proc_charwidth(value));
}

} // namespace proskill::syntax
