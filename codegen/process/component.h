#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The position of each process in the component, 1-based, for the paths of properties.
using Places = std::map<std::string, std::uint32_t, std::less<>>;

/// The whole Fiacre program without its properties.
[[nodiscard]] fiacre::Program buildProgram(Context& context);

/// \pre the program was built
[[nodiscard]] Places placesOf(const fiacre::Program& program);

/// The content of Model::obliged.
[[nodiscard]] std::map<std::string, Obliged> obligedProcesses(Context& context);

} // namespace proskill::codegen
