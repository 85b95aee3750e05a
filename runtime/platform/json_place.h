#pragma once

#include "runtime/platform/json.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace proskill::runtime {

/// Where a part of a file is: line and column, as `3:14`. `1:1` if the file does not have it.
/// \param part a value of `file`, a string in it, or the key of a member: the object itself
/// \pre `file` is what was parsed from the text
[[nodiscard]] std::string placeOfPart(std::string_view text, const Json& file, const void* part);

/// The same of a position in bytes.
[[nodiscard]] std::string placeOfByte(std::string_view text, std::size_t byte);

/// Reads a file: `read` gets it as an object, and throws `Wrong`.
/// \return the error, as `3:14: MESSAGE`
template <class Read>
[[nodiscard]] std::optional<std::string> readFile(std::string_view text, Read&& read) {
  Json file;
  try {
    file = parsedFile(text);
    read(std::as_const(file));
  } catch (const Wrong& wrong) {
    const auto place =
        wrong.byte ? placeOfByte(text, *wrong.byte) : placeOfPart(text, file, wrong.part);
    return place + ": " + wrong.why;
  }
  return std::nullopt;
}

} // namespace proskill::runtime
