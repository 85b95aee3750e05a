#pragma once

#include "report/text/paint.h"

#include <cstdint>

namespace CLI {
class App;
}

namespace proskill::cli {

enum class ColourChoice : std::uint8_t { Auto, Always, Never };

/// Auto: if the stream is a terminal and NO_COLOR is not set.
[[nodiscard]] bool wantsColour(ColourChoice choice, int fileDescriptor);

/// The option `--color auto|always|never` of a subcommand.
void addColour(CLI::App& command, ColourChoice& choice);

} // namespace proskill::cli
