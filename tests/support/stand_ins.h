#pragma once

#include "tests/support/run.h"

#include <string>

namespace proskill::test {

/// Shell programs that replace frac, sift, selt, ktzio and a compiler, which are not available to
/// tests. They print what tests specify, and compute nothing.
class StandIns {
public:
  /// Tools that succeed, with an empty graph and no formulas.
  StandIns();

  /// The content of `model.ltl`.
  void formulas(const std::string& text) { write("model.ltl", text); }
  /// selt's output for verdicts.
  void verdicts(const std::string& text) { write("verdicts", text); }
  /// The file that it writes for `-S`, and its output then.
  void counterexample(const std::string& scenario, const std::string& text);
  /// The end of sift's output.
  void counts(const std::string& text) { write("counts", text); }
  /// ktzio's output.
  void graph(const std::string& text) { write("graph.txt", text); }
  /// Replaces a tool by another one.
  void replace(const std::string& tool, const std::string& body);
  void remove(const std::string& tool);

  /// The directory of the tools, for PATH; FRACLIB is `lib` in it.
  [[nodiscard]] std::string path(const std::string& name = "") const { return files.path(name); }
  void write(const std::string& name, const std::string& text) { files.write(name, text); }
  /// `PATH=…` with this directory in front.
  [[nodiscard]] std::string searchPath() const;

private:
  TemporaryDirectory files;
};

} // namespace proskill::test
