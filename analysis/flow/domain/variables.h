#pragma once

#include "analysis/flow/domain/values.h"
#include "analysis/program/program.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::analysis::flow {

using VariableId = std::uint32_t;

enum class VariableKind : std::uint8_t {
  StateVariable,
  Status, ///< `skill.status`
  Result, ///< `skill.res`: the tags of a skill, and `no_result`
  Called, ///< of a skill: somebody has called it, and it has not returned
  Used,   ///< of a resource
};

/// Where the words of `statusWords()` stand in a status's domain.
enum class Status : std::uint8_t { None, Success, Failure, FailedInvariant, Interrupted };

/// Something whose value the analysis follows.
struct Variable {
  VariableKind kind = VariableKind::StateVariable;
  std::size_t definition = 0; ///< in the program's table of state variables, skills, or resources
  Domain domain;
  ValueSet initial;
  std::vector<ValueSet> allowed; ///< state variables with listed moves: from each class
  bool restricted = false;       ///< some moves are forbidden

  /// The moves from `from` to values of `to` that the program forbids.
  [[nodiscard]] ValueSet forbidden(unsigned from, ValueSet to) const {
    return allowed.empty() ? ValueSet() : to - allowed[from];
  }
};

/// All variables of a program, numbered.
class Variables {
public:
  explicit Variables(const Program& program);

  [[nodiscard]] std::size_t size() const { return all.size(); }
  [[nodiscard]] const Variable& operator[](VariableId id) const { return all[id]; }
  [[nodiscard]] VariableId of(VariableKind kind, std::size_t definition) const;
  /// "`battery`", "`takeoff.status`": what a user calls it.
  [[nodiscard]] std::string name(VariableId id) const;
  /// "Good", "Good or Low", "0..3".
  [[nodiscard]] std::string words(VariableId id, ValueSet values) const;

private:
  void addStateVariable(std::size_t definition, const std::vector<std::int64_t>& cuts);
  void addOfSkills(VariableKind kind);
  void addResource(std::size_t definition);

  const Program& program;
  std::vector<Variable> all; ///< by kind, then by definition: so a set of one kind has long runs
  std::array<VariableId, 5> firstOf{}; ///< of each kind
};

} // namespace proskill::analysis::flow
