#pragma once

#include <cstddef>
#include <string>

namespace proskill::bench {

/// A well-formed program of about so many lines, laid out as a person would: state variables,
/// events, basic skills with all their fields, composite skills that call them, and a mission that
/// calls those.
[[nodiscard]] std::string programOfLines(std::size_t lines);

/// A mission of so many branches in parallel, each of which calls so many skills of its own, one
/// after the other; an event may spoil each branch's state variable at any time.
[[nodiscard]] std::string parallelFamily(std::size_t branches, std::size_t skills);

[[nodiscard]] std::size_t lineCount(const std::string& text);

} // namespace proskill::bench
