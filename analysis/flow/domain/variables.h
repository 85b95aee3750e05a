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
  Called, ///< of a skill: it has been called and has not returned
  Used,   ///< amount of a resource in use
};

/// Indices of the words of `statusWords()` in a status's domain.
enum class Status : std::uint8_t { None, Success, Failure, FailedInvariant, Interrupted };

/// A variable that the analysis tracks.
struct Variable {
  VariableKind kind = VariableKind::StateVariable;
  /// Index in the program's table of state variables, skills or resources.
  std::size_t definition = 0;
  Domain domain;
  ValueSet initial;
  /// State variables with listed transitions: by class, the classes to which it may move.
  std::vector<ValueSet> allowed;
  bool restricted = false; ///< some transitions are forbidden

  /// The values in `to` to which a move from `from` is forbidden.
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
  /// The name for users: "`battery`", "`takeoff.status`".
  [[nodiscard]] std::string name(VariableId id) const;
  /// The values for users: "Good", "Good or Low", "0..3".
  [[nodiscard]] std::string words(VariableId id, ValueSet values) const;

private:
  void addStateVariable(std::size_t definition, const std::vector<std::int64_t>& cuts);
  void addOfSkills(VariableKind kind);
  void addResource(std::size_t definition);

  const Program& program;
  /// By kind, then by definition, so that a set of one kind has long intervals.
  std::vector<Variable> all;
  std::array<VariableId, 5> firstOf{}; ///< by kind
};

} // namespace proskill::analysis::flow
