#pragma once

#include "bridge/text/place.h"

namespace proskill::bridge {

/// A program as a text of another language.
struct Emitted {
  std::string text;
  std::vector<Note> notes; ///< parts of the program that the text lacks, and why
};

} // namespace proskill::bridge
