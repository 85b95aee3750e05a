#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace proskill::cli {

enum class Colour : std::uint8_t { Bold, Dim, Red, Green, Yellow, Blue, Cyan };

/// Wraps text in terminal escapes, or leaves it alone.
struct Paint {
  bool on = false;

  [[nodiscard]] std::string operator()(Colour colour, std::string_view text) const;
};

enum class ColourChoice : std::uint8_t { Auto, Always, Never };

/// Auto: where the stream is a terminal and NO_COLOR is not set.
[[nodiscard]] bool wantsColour(ColourChoice choice, int fileDescriptor);

/// The option `--color auto|always|never` of a subcommand.
void addColour(CLI::App& command, ColourChoice& choice);

} // namespace proskill::cli
