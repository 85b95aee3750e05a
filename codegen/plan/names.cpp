#include "codegen/plan/names.h"

#include <algorithm>

namespace proskill::codegen {

Names::Names(const analysis::Program& program, const GenerationPlan& plan)
    : global({"skill",
              "None",
              "root",
              "no_status",
              "success",
              "failure",
              "failed_inv",
              "interrupted",
              "no_result",
              "skill_id",
              "skill_status",
              "skill_result",
              "skill_record",
              "skill_array",
              "invariant_active",
              "stopping",
              "over",
              "ret_val",
              "ignoreb",
              "undershoot",
              "overshoot",
              "most_general_caller"}) {
  for (const auto& sv : program.stateVariables.all) {
    variable(sv.name());
    for (const auto& state : sv->states) ++ownersOfValue[state.text];
  }
  for (const auto& event : program.events.all) this->event(event.name());
  for (const auto& skill : plan.skills) {
    cell(skill.name());
    if (!skill.body) continue;
    forEachThread(*skill.body, [&](const BodyAutomaton& thread) { cell(thread.name); });
  }
  for (const auto& sv : program.stateVariables.all)
    for (const auto& state : sv->states) value(sv.name(), state.text);
}

const std::string& Names::value(std::string_view sv, std::string_view value) {
  return ownersOfValue[value] > 1 ? global.of("value", {sv, value})
                                  // the empty part avoids the key of the variable itself
                                  : global.of("value", {"", value});
}

std::string sanitised(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!isLetter && (c < '0' || c > '9')) c = '_';
  }
  return result;
}

} // namespace proskill::codegen
