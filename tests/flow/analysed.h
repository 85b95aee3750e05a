#pragma once

#include "analysis/flow/engine/solver.h"

#include <memory>
#include <string>
#include <string_view>

namespace proskill::test {

/// A program from a text, and what the flow analysis knows about it.
class Analysed {
public:
  explicit Analysed(std::string text);

  /// What `variable` ("motion", "takeoff.status") may be just before the statement that begins like
  /// `statement` does what it says: "Free or Controlled", "unreachable", or "not followed".
  [[nodiscard]] std::string at(std::string_view statement, std::string_view variable) const;
  [[nodiscard]] bool reaches(std::string_view statement) const;
  /// All that the variable may ever be.
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
