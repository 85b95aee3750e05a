#pragma once

#include <cstddef>
#include <string>

namespace proskill::bench {

/// A formatted program of about this many lines: state variables, events, basic skills with all
/// their fields, composite skills that call them, and a mission that calls those.
[[nodiscard]] std::string programOfLines(std::size_t lines);

/// A mission with this many parallel branches, each of which calls so many skills of its own in
/// sequence. An event may change each branch's state variable at any time.
[[nodiscard]] std::string parallelFamily(std::size_t branches, std::size_t skills);

/// The text of the paper's mission, from the examples. Ends the process if it cannot be read.
[[nodiscard]] std::string drone();

[[nodiscard]] std::size_t lineCount(const std::string& text);

} // namespace proskill::bench
