#pragma once

#include "runtime/platform/file_error.h"
#include "runtime/platform/json.h"

#include <optional>
#include <string_view>
#include <utility>

namespace proskill::runtime {

/// Where a part of a file is. Its beginning if the file does not have the part.
/// \param part a value of `file`, a string in it, or the key of a member: the object itself
/// \pre `file` is what was parsed from the text
[[nodiscard]] FilePlace placeOfPart(std::string_view text, const Json& file, const void* part);

/// The same of a position in bytes.
[[nodiscard]] FilePlace placeOfByte(std::string_view text, std::size_t byte);

/// Reads a file: `read` gets it as an object, and throws `Wrong`.
/// \return the error, with its place
template <class Read>
[[nodiscard]] std::optional<FileError> readFile(std::string_view text, Read&& read) {
  Json file;
  try {
    file = parsedFile(text);
    read(std::as_const(file));
  } catch (const Wrong& wrong) {
    return FileError{wrong.why, wrong.byte ? placeOfByte(text, *wrong.byte)
                                           : placeOfPart(text, file, wrong.part)};
  }
  return std::nullopt;
}

} // namespace proskill::runtime
