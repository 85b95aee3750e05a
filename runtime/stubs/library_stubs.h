#pragma once

#include "runtime/stubs/stub_text.h"
#include "runtime/stubs/stubs.h"

/// What stubs in C and in C++ share.
namespace proskill::runtime {

/// Words that neither language lets one use, and what the generated text uses itself.
[[nodiscard]] std::span<const std::string_view> reservedInC();

/// The names of an action's parameters, in their order.
[[nodiscard]] std::vector<std::string> parameterNames(const StubAction& action);

/// The first line of `:action`, as a comment may have it; empty where there is none.
[[nodiscard]] std::string actionLine(const StubAction& action);

/// `platform.json`, the makefile and copies of the headers.
/// \param sources of the library
[[nodiscard]] std::vector<StubFile> libraryFiles(std::string_view compiler,
                                                 const std::vector<std::string>& sources,
                                                 const std::string& header);

} // namespace proskill::runtime
