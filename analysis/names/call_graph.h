#pragma once

#include "analysis/program/program.h"

#include <span>
#include <vector>

namespace proskill::analysis {

/// The calls between skills, by index into `Program::skills.all`. Calls of unknown skills are
/// omitted.
class CallGraph {
public:
  struct Call {
    std::size_t callee;
    const syntax::Statement* statement; ///< with ranges as parsed, see syntax::Form
  };

  explicit CallGraph(const Program& program);

  [[nodiscard]] std::size_t size() const { return firsts.size() - 1; }
  /// The calls in a skill's body, in the order of the text.
  [[nodiscard]] std::span<const Call> from(std::size_t skill) const {
    return std::span(calls).subspan(firsts[skill], firsts[skill + 1] - firsts[skill]);
  }
  /// The calls in a part of a body with ranges as parsed.
  [[nodiscard]] std::vector<Call> in(const syntax::Block& block) const;

private:
  void add(const syntax::Statement& call, std::vector<Call>& to) const;

  const Program& program;
  std::vector<Call> calls;         ///< grouped by skill
  std::vector<std::size_t> firsts; ///< by skill: its first index in `calls`; then the end
};

} // namespace proskill::analysis
