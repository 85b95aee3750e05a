#pragma once

#include "runtime/stubs/stub_names.h"
#include "runtime/stubs/stubs.h"

#include <functional>
#include <string>
#include <string_view>

/// What stubs of all languages need: names, arguments, and the mark of generated files.
namespace proskill::runtime {

/// The names of an action's parameters, in order.
/// \param around the names that they may not hide
[[nodiscard]] std::vector<std::string> parameterNames(const StubAction& action, StubNames around);

/// The first line of `:action`, safe in a comment; empty if there is none.
[[nodiscard]] std::string actionLine(const StubAction& action);

/// One text for each kind of argument.
struct ArgumentTexts {
  std::string integer;
  std::string number;
  std::string boolean;
  std::string string;
};

/// The text for an argument's kind.
/// \param ofVariable returns the text for values of the variable with this index
[[nodiscard]] std::string textFor(const StubProgram& program, const StubType& type,
                                  const ArgumentTexts& texts,
                                  const std::function<std::string(std::size_t)>& ofVariable);

/// Puts the mark of generated files before a text. It contains a hash of the text.
/// \param comment start of a comment: `#`
[[nodiscard]] std::string withStubMark(std::string_view comment, std::string_view text);

} // namespace proskill::runtime
