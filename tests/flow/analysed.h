#pragma once

#include "analysis/flow/engine/solver.h"

#include <memory>
#include <string>
#include <string_view>

namespace proskill::test {

/// A program and the results of its flow analysis.
class Analysed {
public:
  explicit Analysed(std::string text);

  /// The values of `variable` ("motion", "takeoff.status") just before the statement that begins
  /// like `statement`: "Free or Controlled", "unreachable", or "not followed".
  [[nodiscard]] std::string at(std::string_view statement, std::string_view variable) const;
  [[nodiscard]] bool reaches(std::string_view statement) const;
  /// All values that the variable may ever have.
  [[nodiscard]] std::string ever(std::string_view variable) const;

private:
  struct Place {
    analysis::flow::ProcessId process;
    analysis::flow::NodeId node;
  };
  [[nodiscard]] Place find(std::string_view statement) const;
  [[nodiscard]] analysis::flow::VariableId variable(std::string_view name) const;

  analysis::Program program;
  std::unique_ptr<analysis::flow::System> system;
  std::unique_ptr<analysis::flow::Solver> solver;
};

} // namespace proskill::test
