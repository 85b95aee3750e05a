#pragma once

#include "runtime/stubs/stub_text.h"
#include "runtime/stubs/stubs.h"

/// What stubs in C and in C++ share.
namespace proskill::runtime {

/// Keywords of C or C++, and names that the generated text uses itself.
[[nodiscard]] std::span<const std::string_view> reservedInC();

/// The names of an action's parameters, in order.
[[nodiscard]] std::vector<std::string> parameterNames(const StubAction& action);

/// The first line of `:action`, safe in a comment; empty if there is none.
[[nodiscard]] std::string actionLine(const StubAction& action);

/// `platform.json`, the makefile and copies of the headers.
/// \param sources of the library
[[nodiscard]] std::vector<StubFile> libraryFiles(std::string_view compiler,
                                                 const std::vector<std::string>& sources,
                                                 const std::string& header);

} // namespace proskill::runtime
