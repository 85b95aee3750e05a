#pragma once

#include "analysis/program/program.h"

#include <span>
#include <vector>

namespace proskill::analysis {

/// Who calls whom, by index into `Program::skills.all`. A call of an unknown skill is no edge.
class CallGraph {
public:
  struct Call {
    std::size_t callee;
    const syntax::Statement* statement; ///< as it was read, see syntax::Form
  };

  explicit CallGraph(const Program& program);

  [[nodiscard]] std::size_t size() const { return firsts.size() - 1; }
  /// The calls in a skill's body, in the order of the text.
  [[nodiscard]] std::span<const Call> from(std::size_t skill) const {
    return std::span(calls).subspan(firsts[skill], firsts[skill + 1] - firsts[skill]);
  }
  /// Those in a part of a body, as it was read.
  [[nodiscard]] std::vector<Call> in(const syntax::Block& block) const;

private:
  void add(const syntax::Statement& call, std::vector<Call>& to) const;

  const Program& program;
  std::vector<Call> calls;         ///< of one skill after the other
  std::vector<std::size_t> firsts; ///< of each skill in `calls`, and the end
};

} // namespace proskill::analysis
