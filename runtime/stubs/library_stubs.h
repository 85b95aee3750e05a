#pragma once

#include "runtime/stubs/stub_text.h"

/// What stubs in C and in C++ share.
namespace proskill::runtime {

/// The expression that passes on the argument at this position.
/// \param reader returns the name of the function that reads values of the variable with this index
[[nodiscard]] std::string argumentText(const StubProgram& program, const StubType& type,
                                       std::size_t place,
                                       const std::function<std::string(std::size_t)>& reader);

/// `platform.json`, the makefile and copies of the headers.
/// \param sources of the library
[[nodiscard]] std::vector<StubFile> libraryFiles(std::string_view compiler,
                                                 const std::vector<std::string>& sources,
                                                 const std::string& header);

} // namespace proskill::runtime
