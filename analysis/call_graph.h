#pragma once

#include "analysis/program.h"

#include <span>
#include <vector>

namespace proskill::analysis {

/// Who calls whom, by index into `Program::skills.all`. A call of an unknown skill is no edge.
class CallGraph {
public:
  struct Call {
    std::size_t callee;
    const syntax::Statement* statement;
  };

  explicit CallGraph(const Program& program);

  [[nodiscard]] std::size_t size() const { return calls.size(); }
  /// The calls in a skill's body, in the order of the text.
  [[nodiscard]] std::span<const Call> from(std::size_t skill) const { return calls[skill]; }
  /// The calls in a part of a body.
  [[nodiscard]] std::vector<Call> in(const syntax::Block& block) const;

private:
  const Program& program;
  std::vector<std::vector<Call>> calls;
};

} // namespace proskill::analysis
