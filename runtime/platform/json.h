#pragma once

#include "runtime/machine/executable.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Reads JSON that users and platforms write. Errors are thrown as `Wrong`, and caught where the
/// file or message is read.
namespace proskill::runtime {

/// Its members are sorted by name, so that objects of any size are read and searched in little
/// time.
using Json = nlohmann::json;

/// An error, as a message for users.
struct Wrong {
  std::string why;
  /// The value, the string or the key that is wrong: the object itself, as it was parsed. null: the
  /// whole file, or unknown.
  const void* part = nullptr;
  std::string skill{}; ///< the skill that it is about, instead of a part of the file
};

/// Collects the errors of a file: after one, the rest is still read.
class Errors {
public:
  void note(Wrong wrong) { noted.push_back(std::move(wrong)); }
  /// Makes a call. \return its value, or an empty one if it throws `Wrong`
  template <class Call> auto attempt(Call&& call) {
    using Value = std::remove_cvref_t<std::invoke_result_t<Call>>;
    try {
      return static_cast<Value>(call());
    } catch (Wrong& wrong) {
      note(std::move(wrong));
      return Value();
    }
  }
  [[nodiscard]] const std::vector<Wrong>& all() const { return noted; }

private:
  std::vector<Wrong> noted;
};

/// Whether lists and objects are nested deeper than in anything that people write. Functions that
/// follow them would exhaust the stack.
[[nodiscard]] bool isTooDeep(std::string_view text);

/// Discarded if the text is not JSON, or nested too deep.
[[nodiscard]] Json parsedText(std::string_view text);

/// Notes the members of an object that are not known. Throws unless it is an object.
void allowMembers(const Json& value, const std::vector<std::string>& known,
                  const std::string& where, Errors& errors);
[[nodiscard]] const Json& listOf(const Json& value, const std::string& of);
/// An optional member whose value is an object.
[[nodiscard]] const Json::object_t& objectAt(const Json& file, const std::string& key);
/// A required member whose value is a string.
[[nodiscard]] const std::string& stringAt(const Json& value, const std::string& key);
[[nodiscard]] Nanoseconds secondsOf(const Json& value, const std::string& of);
/// `[LEAST, MOST]`, in seconds
[[nodiscard]] Span spanOf(const Json& value, const std::string& of);

/// The error for an unknown name, with a suggestion.
/// \param name the string of the file itself, so that its place is known
[[nodiscard]] Wrong unknown(const std::string& what, const std::string& name,
                            const std::vector<std::string>& names);

} // namespace proskill::runtime
