#pragma once

#include "codegen/model.h"
#include "codegen/plan/plan.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::codegen {

/// The arguments with which each skill is called, found by following calls from the mission and the
/// monitors. An argument may be a parameter of the caller, so it depends on how the caller was
/// called. The argument sets of a skill are numbered from 1; 0 is a call without arguments.
class CallTable {
public:
  /// The literals of a set, as written, in the order of the skill's `:input`; empty where no
  /// argument was given.
  using Values = std::vector<std::string>;

  CallTable() = default;
  CallTable(const analysis::Program& program, const GenerationPlan& plan);

  /// For a call: from the number of the caller's argument set to the number of the callee's.
  [[nodiscard]] const std::map<std::int64_t, std::int64_t>&
  numbersOf(const syntax::Statement& call) const;
  /// The skill whose body contains the call.
  [[nodiscard]] std::string_view callerOf(const syntax::Statement& call) const;
  [[nodiscard]] std::int64_t last() const;
  /// The actions that basic skills request from the platform, one for each argument set.
  [[nodiscard]] std::vector<ActionCall> actions() const;

private:
  struct Call {
    std::string_view caller;
    std::map<std::int64_t, std::int64_t> numbers;
  };

  void follow(const SkillPlan& skill, std::int64_t number);
  std::int64_t add(const SkillPlan& skill, Values values);
  [[nodiscard]] Values argumentsOf(const syntax::Statement& call, const SkillPlan& callee,
                                   const SkillPlan& caller, const Values& given) const;
  [[nodiscard]] std::string valueOf(const syntax::Expr& expr, const SkillPlan& skill,
                                    const Values& given) const;

  const analysis::Program* program = nullptr;
  const GenerationPlan* plan = nullptr;
  std::map<std::string_view, std::map<std::int64_t, Values>> sets;
  std::map<const syntax::Statement*, Call> calls;
};

} // namespace proskill::codegen
