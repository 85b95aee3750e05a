#pragma once

#include "runtime/machine/executable.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

/// Reading what users and platforms write as JSON. What is wrong is thrown, and caught where the
/// file or the message is read.
namespace proskill::runtime {

using Json = nlohmann::ordered_json;

/// What is wrong, in words.
struct Wrong {
  std::string why;
};

/// \return an object
[[nodiscard]] Json parsedFile(std::string_view text);

/// Where the value of a member of the whole object is: `3:14`. \pre it is JSON and has the member
[[nodiscard]] std::string placeOfMember(std::string_view text, std::string_view name);

/// That an object has no members but these.
void allowMembers(const Json& value, const std::vector<std::string>& known,
                  const std::string& where);
[[nodiscard]] const Json& listOf(const Json& value, const std::string& of);
/// The members of an object that may be missing.
[[nodiscard]] const Json::object_t& objectAt(const Json& file, const std::string& key);
/// A string that has to be there.
[[nodiscard]] const std::string& stringAt(const Json& value, const std::string& key);
[[nodiscard]] Nanoseconds secondsOf(const Json& value, const std::string& of);
/// `[LEAST, MOST]`, in seconds
[[nodiscard]] Span spanOf(const Json& value, const std::string& of);

/// There is no such name; what it might be is said too.
[[noreturn]] void throwUnknown(const std::string& what, const std::string& name,
                               const std::vector<std::string>& names);

} // namespace proskill::runtime
