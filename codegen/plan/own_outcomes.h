#pragma once

#include "codegen/plan/body_automaton.h"

#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace proskill::codegen {

struct GenerationPlan;

/// What a thread of a body reads after its own calls of a skill.
struct OwnOutcome {
  bool status = false;
  bool result = false;
};

/// The outcomes that bodies keep for themselves. If several processes call a skill, a body reads
/// the outcome of its own call, whoever has called the skill since. The outcome belongs to the
/// innermost thread around the reader that calls the skill, itself or in a branch.
class OwnOutcomes {
public:
  OwnOutcomes() = default;
  /// \pre the callers of all skills are known
  explicit OwnOutcomes(const GenerationPlan& plan);

  /// The thread whose outcome `reader` reads; empty if it reads the skill's last call by anybody.
  [[nodiscard]] std::string_view ownerFor(std::string_view reader, std::string_view skill) const;
  /// The threads that record what happens to a call by `caller`.
  [[nodiscard]] std::vector<std::string_view> toldBy(std::string_view caller,
                                                     std::string_view skill) const;
  [[nodiscard]] const OwnOutcome& of(std::string_view thread, std::string_view skill) const {
    return kept.at({thread, skill});
  }
  /// By thread and skill.
  [[nodiscard]] const auto& all() const { return kept; }

private:
  using Pair = std::pair<std::string_view, std::string_view>;

  void noteCalls(const BodyAutomaton& thread, std::string_view parent, const GenerationPlan& plan);
  void noteReads(const BodyAutomaton& thread);
  void noteReads(std::string_view thread, const syntax::Expr& condition);

  std::map<std::string_view, std::string_view> parentOf;
  /// Threads that call a shared skill, themselves or in a branch.
  std::map<Pair, OwnOutcome> callers;
  std::map<Pair, OwnOutcome> kept; ///< the callers whose outcome is read
};

} // namespace proskill::codegen
