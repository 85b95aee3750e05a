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
  StateVariable, ///< its values, and the allowed moves between them
  Event,         ///< when it occurs, and its effects
  Skill,         ///< a basic skill from its call to its outcomes; a composite skill's body
  Body,          ///< the statements of a composite skill or of an environment
  Calls,         ///< which skills call and interrupt which
};

/// The names of kinds, on the command line and in JSON.
inline constexpr std::array kKindWords{std::pair<std::string_view, Kind>{"sv", Kind::StateVariable},
                                       std::pair<std::string_view, Kind>{"event", Kind::Event},
                                       std::pair<std::string_view, Kind>{"skill", Kind::Skill},
                                       std::pair<std::string_view, Kind>{"body", Kind::Body},
                                       std::pair<std::string_view, Kind>{"calls", Kind::Calls}};
[[nodiscard]] std::string_view wordOf(Kind kind);
[[nodiscard]] std::optional<Kind> kindOf(std::string_view word);

/// Selects a picture of a program.
struct Request {
  Kind kind = Kind::Calls;
  std::string name;       ///< of the definition; unused for Calls
  bool forbidden = false; ///< state variables: also show the moves that are not allowed
};

/// The picture, or why it cannot be drawn. Works also for programs with errors; parts that are not
/// understood are omitted.
[[nodiscard]] std::expected<Graph, std::string> draw(const analysis::Program& program,
                                                     const Request& request);

/// All pictures of a program, or all of one kind, in the order of its text.
[[nodiscard]] std::vector<Request> allPictures(const analysis::Program& program);
[[nodiscard]] std::vector<Request> allPictures(const analysis::Program& program, Kind kind);

} // namespace proskill::viz
