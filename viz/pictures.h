#pragma once

#include "analysis/program/program.h"
#include "viz/graph.h"

#include <array>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace proskill::viz {

enum class Kind : std::uint8_t {
  StateVariable, ///< its values, and the moves between them that are allowed
  Skill,         ///< a basic skill from its call to its outcomes; of a composite skill its body
  Body,          ///< the statements of a composite skill or of an environment
  Calls,         ///< who calls and who interrupts whom
};

/// The words for kinds, on the command line and in JSON.
inline constexpr std::array kKindWords{std::pair<std::string_view, Kind>{"sv", Kind::StateVariable},
                                       std::pair<std::string_view, Kind>{"skill", Kind::Skill},
                                       std::pair<std::string_view, Kind>{"body", Kind::Body},
                                       std::pair<std::string_view, Kind>{"calls", Kind::Calls}};
[[nodiscard]] std::string_view wordOf(Kind kind);
[[nodiscard]] std::optional<Kind> kindOf(std::string_view word);

/// Which picture of a program.
struct Request {
  Kind kind = Kind::Calls;
  std::string name;       ///< of what; of no meaning for Calls
  bool forbidden = false; ///< of a state variable: the moves that are not allowed, too
};

/// The picture, or why there is none. Any program will do, also one with errors: what cannot be
/// understood is left out.
[[nodiscard]] std::expected<Graph, std::string> draw(const analysis::Program& program,
                                                     const Request& request);

/// All pictures of a program, or all of one kind, in the order of its text.
[[nodiscard]] std::vector<Request> allPictures(const analysis::Program& program);
[[nodiscard]] std::vector<Request> allPictures(const analysis::Program& program, Kind kind);

} // namespace proskill::viz
