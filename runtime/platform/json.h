#pragma once

#include "runtime/machine/executable.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Reads JSON that users and platforms write. Errors are thrown as `Wrong`, and caught where the
/// file or message is read.
namespace proskill::runtime {

using Json = nlohmann::ordered_json;

/// An error, as a message for users.
struct Wrong {
  std::string why;
  /// The value, the string or the key that is wrong: the object itself, as it was parsed. null: the
  /// whole file, or unknown.
  const void* part = nullptr;
  std::optional<std::size_t> byte{}; ///< where the file is not JSON
};

/// Discarded if the text is not JSON, or nested so deep that a copy would exhaust the stack:
/// objects that keep their order are copied when they grow.
[[nodiscard]] Json parsedText(std::string_view text);

/// \return an object
[[nodiscard]] Json parsedFile(std::string_view text);

/// Throws unless these are the only members of an object.
void allowMembers(const Json& value, const std::vector<std::string>& known,
                  const std::string& where);
[[nodiscard]] const Json& listOf(const Json& value, const std::string& of);
/// An optional member whose value is an object.
[[nodiscard]] const Json::object_t& objectAt(const Json& file, const std::string& key);
/// A required member whose value is a string.
[[nodiscard]] const std::string& stringAt(const Json& value, const std::string& key);
[[nodiscard]] Nanoseconds secondsOf(const Json& value, const std::string& of);
/// `[LEAST, MOST]`, in seconds
[[nodiscard]] Span spanOf(const Json& value, const std::string& of);

/// Throws an error for an unknown name, with a suggestion.
/// \param name the string of the file itself, so that its place is known
[[noreturn]] void throwUnknown(const std::string& what, const std::string& name,
                               const std::vector<std::string>& names);

} // namespace proskill::runtime
