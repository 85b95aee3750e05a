#pragma once

#include <string>
#include <vector>

namespace proskill::bridge {

/// A file of another language as a program.
struct Imported {
  std::string text;
  bool exact = true; ///< nothing was approximated
  /// For people: what was imported, what was approximated, and what verdicts mean.
  std::vector<std::string> summary;
};

} // namespace proskill::bridge
