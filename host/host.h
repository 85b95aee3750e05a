#pragma once

#include <map>
#include <string>

/// Process in which a shared library performs the actions of a program: the other end of the
/// protocol of docs/platforms.md. If the library crashes or hangs, this process fails, not the
/// executor.
namespace proskill::host {

/// Speaks the protocol on standard input and output until the run is over.
/// \param functions by skill: functions whose names differ from the skill's
/// \return the exit code
int runLibrary(const std::string& path, const std::map<std::string, std::string>& functions);

} // namespace proskill::host
