#pragma once

#include "runtime/platform/file_error.h"
#include "runtime/platform/json.h"

#include <expected>
#include <string>
#include <string_view>
#include <utility>

namespace proskill::runtime {

/// A platform file or a script: an object, parsed once.
class JsonFile {
public:
  [[nodiscard]] static std::expected<JsonFile, FileErrors> parse(std::string_view text);

  [[nodiscard]] const Json& json() const { return object; }
  /// Where a part of the file is; its beginning if the file does not have the part.
  /// \param part a value, a string, or the key of a member: the object itself
  [[nodiscard]] FilePlace placeOf(const void* part) const;
  /// Reads it: `read` gets the object, and notes or throws what is wrong.
  /// \return the errors, in the order of the file
  template <class Read> [[nodiscard]] FileErrors read(Read&& read) const {
    Errors errors;
    errors.attempt([&] { read(object, errors); });
    return placed(errors);
  }

private:
  JsonFile(std::string_view of, Json parsed) : text(of), object(std::move(parsed)) {}
  [[nodiscard]] FileErrors placed(const Errors& errors) const;

  std::string text;
  Json object;
};

} // namespace proskill::runtime
