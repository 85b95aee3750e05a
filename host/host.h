#pragma once

#include <map>
#include <string>

/// The process in which a shared library performs the actions of a program: the other end of the
/// protocol of docs/platforms.md. A library that crashes or hangs takes this process with it, and
/// not the executor.
namespace proskill::host {

/// Speaks the protocol on the standard input and output until the run is over.
/// \param functions by skill: the names of functions that are not called after it
/// \return the exit code
int runLibrary(const std::string& path, const std::map<std::string, std::string>& functions);

} // namespace proskill::host
