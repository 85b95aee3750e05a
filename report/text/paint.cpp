#include "report/text/paint.h"

namespace proskill::report {

namespace {

std::string_view escape(Colour colour) {
  switch (colour) {
  case Colour::Bold: return "\x1b[1m";
  case Colour::Dim: return "\x1b[2m";
  case Colour::Red: return "\x1b[1;31m";
  case Colour::Green: return "\x1b[32m";
  case Colour::Yellow: return "\x1b[33m";
  case Colour::Blue: return "\x1b[1;34m";
  case Colour::Cyan: return "\x1b[36m";
  }
  return "";
}

} // namespace

std::string Paint::operator()(Colour colour, std::string_view text) const {
  if (!on) return std::string(text);
  return std::string(escape(colour)).append(text).append("\x1b[0m");
}

} // namespace proskill::report
