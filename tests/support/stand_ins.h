#pragma once

#include "tests/support/run.h"

#include <string>

namespace proskill::test {

/// Programs of shell that stand in for frac, sift, selt, ktzio and a compiler: the real ones are
/// not there when tests run. What they say is what is given here, nothing is computed.
class StandIns {
public:
  /// Tools that do what they should, with a graph that has nothing and no formulas.
  StandIns();

  /// What `model.ltl` is.
  void formulas(const std::string& text) { write("model.ltl", text); }
  /// What selt says when it is asked for verdicts.
  void verdicts(const std::string& text) { write("verdicts", text); }
  /// What it writes for `-S`, and what it says then.
  void counterexample(const std::string& scenario, const std::string& text);
  /// What sift says at its end.
  void counts(const std::string& text) { write("counts", text); }
  /// What ktzio writes.
  void graph(const std::string& text) { write("graph.txt", text); }
  /// Another tool in the place of one.
  void replace(const std::string& tool, const std::string& body);
  void remove(const std::string& tool);

  /// The directory of the tools, to be put on the PATH; FRACLIB is `lib` in it.
  [[nodiscard]] std::string path(const std::string& name = "") const { return files.path(name); }
  void write(const std::string& name, const std::string& text) { files.write(name, text); }
  /// `PATH=…`, for a program that looks there. The PATH as it is remains behind.
  [[nodiscard]] std::string searchPath() const;

private:
  TemporaryDirectory files;
};

} // namespace proskill::test
