#pragma once

#include "include/proskill/executor.h"
#include "tests/support/run.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace proskill::test {

/// An action that ends after some seconds; without a result: when it is asked to stop.
struct Scripted {
  double seconds = 0;
  std::string result;
};

/// A program in a file, executed with functions of the test.
class Embedded {
public:
  /// In simulated time.
  explicit Embedded(const std::string& text, proskill_options options = simulated());
  /// With the file `robot.json` beside the program. The executor may be refused.
  Embedded(const std::string& text, const std::string& platform, const proskill_options* options);
  ~Embedded();
  Embedded(const Embedded&) = delete;
  Embedded& operator=(const Embedded&) = delete;

  [[nodiscard]] static proskill_options simulated();

  void perform(const std::string& skill, Scripted action);
  [[nodiscard]] proskill_error performBy(const char* skill, proskill_begin begin,
                                         proskill_stop stop = nullptr);
  /// What has happened, each as `2.5 fly: succeeds with `there``.
  [[nodiscard]] const std::string& text() const { return happened; }
  [[nodiscard]] std::string value(const char* name) const;
  /// The text of the last error, without the directory of the program.
  [[nodiscard]] std::string error() const;
  [[nodiscard]] std::string path(const std::string& name) const { return files.path(name); }

  proskill_program* program = nullptr;
  proskill_executor* executor = nullptr;
  proskill_error made = PROSKILL_OK; ///< whether the executor was refused

private:
  static void begin(proskill_executor*, proskill_run, const proskill_value*, size_t, void*);
  static void stop(proskill_executor*, proskill_run, void*);
  static void observe(proskill_executor*, const proskill_entry*, void*);

  TemporaryDirectory files;
  std::map<std::string, Scripted> scripted;
  std::string happened;
};

/// Loads a program that is written to a file. \return what was wrong with it
[[nodiscard]] std::string loadError(const std::string& text, proskill_error code);

} // namespace proskill::test
