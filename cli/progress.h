#pragma once

#include "verify/verify.h"

#include <functional>

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

private:
  void show(const verify::Progress& progress);

  bool terminal = false;
  bool shown = false;
};

} // namespace proskill::cli
