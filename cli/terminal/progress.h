#pragma once

#include "verify/verify.h"

#include <functional>
#include <string>

namespace proskill::cli {

/// One line on a terminal that tells how far an exploration is; nothing where standard error is no
/// terminal. The line is gone when the object is.
class ProgressLine {
public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Empty where there is no terminal.
  [[nodiscard]] std::function<void(const verify::Progress&)> callback();

  /// Puts this in place of what stands there; does nothing where there is no terminal.
  void say(const std::string& line);

private:
  void show(const verify::Progress& progress);

  bool terminal = false;
  bool shown = false;
};

} // namespace proskill::cli
