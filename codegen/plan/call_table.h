#pragma once

#include "codegen/model.h"
#include "codegen/plan/plan.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::codegen {

/// With which arguments each skill is called, found from the mission and the monitors on: those of
/// a call may be parameters of its caller, so they depend on how that was called. A skill's sets
/// of arguments are numbered from 1; 0 is a call without any.
class CallTable {
public:
  /// The literals of a set, as written, by the skill's `:input`; empty where nothing was given.
  using Values = std::vector<std::string>;

  CallTable() = default;
  CallTable(const analysis::Program& program, const GenerationPlan& plan);

  /// The number of the arguments of a call, by the number of its caller's.
  [[nodiscard]] const std::map<std::int64_t, std::int64_t>&
  numbersOf(const syntax::Statement& call) const;
  /// The skill whose body has the call.
  [[nodiscard]] std::string_view callerOf(const syntax::Statement& call) const;
  [[nodiscard]] std::int64_t last() const;
  /// What each basic skill asks of the platform, for each of its sets.
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
