#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// Where each process stands in the component, for the paths of properties: 1-based.
using Places = std::map<std::string, std::uint32_t, std::less<>>;

/// The whole Fiacre program but for its properties.
[[nodiscard]] fiacre::Program buildProgram(Context& context);

/// \pre the program was built.
[[nodiscard]] Places placesOf(const fiacre::Program& program);

/// Those of Model::obliged.
[[nodiscard]] std::map<std::string, std::string> obligedProcesses(Context& context);

} // namespace proskill::codegen
