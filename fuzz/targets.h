#pragma once

#include <string_view>

/// Properties that hold for any bytes. Each function throws if one does not. libFuzzer searches for
/// such bytes, and tests/fuzz/ runs those that were found.
namespace proskill::fuzz {

/// As a program: parses, checks, formats and edits it.
void proskill(std::string_view bytes);
/// As a Fiacre model: parses, checks, prints and formats it.
void fiacre(std::string_view bytes);
/// As messages of a client to the language server. The first byte determines the size of the pieces
/// into which the rest is cut.
void protocol(std::string_view bytes);

/// As requests of a browser to `proskill view`.
void http(std::string_view bytes);
/// As a behavior tree in XML: reads and translates it, and checks the program.
void bt(std::string_view bytes);
/// As a skillset of the robot language: the same, and writes it again.
void rl(std::string_view bytes);
/// As a component of GenoM3: reads and translates it, and checks the program.
void gen(std::string_view bytes);
/// As the side file about the leaves of a behavior tree: reads it, and translates a tree with it.
void leaves(std::string_view bytes);
/// As output of the Tina tools.
void tina(std::string_view bytes);

/// \throws std::logic_error if a condition is violated
void expect(bool condition, std::string_view what);

} // namespace proskill::fuzz
