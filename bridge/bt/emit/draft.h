#pragma once

#include "bridge/bt/read/xml.h"
#include "bridge/text/locate.h"

#include <fmt/format.h>

namespace proskill::bridge::bt {

/// What was found while a program is written as a tree.
struct Draft {
  const analysis::Program& program;
  Errors errors;
  std::vector<Note> notes;

  void fail(analysis::Location at, std::string_view what) {
    errors.push_back({placeOf(program, at), fmt::format("a tree cannot say this: {}", what)});
  }
  void note(analysis::Location at, std::string_view what) {
    notes.push_back({placeOf(program, at), fmt::format("not in the tree: {}", what)});
  }
};

} // namespace proskill::bridge::bt
