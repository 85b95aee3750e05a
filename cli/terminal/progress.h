#pragma once

#include "verify/verify.h"

#include <functional>
#include <string>

namespace proskill::cli {

/// A progress line on the terminal; prints nothing if standard error is not a terminal. The
/// destructor removes the line.
class ProgressLine {
public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Empty if there is no terminal.
  /// \param more adds to the end of each line; may be empty
  [[nodiscard]] std::function<void(const verify::Progress&)>
  callback(std::function<std::string()> more = {});

  /// Replaces the current line; does nothing without a terminal.
  void say(const std::string& line);

private:
  void show(const verify::Progress& progress, const std::string& more);

  bool terminal = false;
  bool shown = false;
};

} // namespace proskill::cli
