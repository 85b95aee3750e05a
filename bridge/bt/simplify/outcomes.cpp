#include "bridge/bt/simplify/outcomes.h"

#include <algorithm>
#include <map>
#include <set>

namespace proskill::bridge::bt {
namespace {

/// What a body may end with.
struct Outcomes {
  bool succeeds = false; ///< with `done`
  std::vector<std::string> failures;

  [[nodiscard]] bool canBe(const std::string& field, const std::string& value) const {
    if (field == "status" && value == "success") return succeeds;
    if (field == "status") return value != "failure" || !failures.empty();
    return (succeeds && value == "done") || std::ranges::find(failures, value) != failures.end();
  }
};

Outcomes outcomesOf(const Form& body) {
  Outcomes outcomes{contains(body, list("success", "done")), {}};
  for (const auto* name : {"failed", "skipped"})
    if (contains(body, list("failure", name))) outcomes.failures.emplace_back(name);
  return outcomes;
}

void declare(Form& skill, const Outcomes& outcomes) {
  auto& parts = skill.parts;
  const auto isOutcome = [](const Form& part) {
    return part == ":success" || part == ":failure" || part == ":body";
  };
  parts.erase(std::ranges::find_if(parts, isOutcome), parts.end() - 2);
  Block fields;
  if (outcomes.succeeds) append(fields, {":success", "done"});
  if (outcomes.failures.size() == 1) append(fields, {":failure", Form(outcomes.failures.front())});
  if (outcomes.failures.size() == 2) append(fields, {":failure", list("failed", "skipped")});
  parts.insert(parts.end() - 2, fields.begin(), fields.end());
}

using Skills = std::map<std::string, Outcomes>;

/// Whether the form compares the status or the result of a composite skill with what it cannot be.
bool isImpossible(const Form& form, const Skills& skills) {
  const auto& parts = form.parts;
  if (parts.size() != 3 || (parts[0] != "=" && parts[0] != "/=")) return false;
  const auto dot = parts[1].word.find('.');
  const auto skill = skills.find(parts[1].word.substr(0, dot));
  return dot != std::string::npos && skill != skills.end() &&
         !skill->second.canBe(parts[1].word.substr(dot + 1), parts[2].word);
}

bool decideIn(Form& form, const Skills& skills) {
  if (isImpossible(form, skills)) {
    form = Form(form.parts[0] == "=" ? "false" : "true");
    return true;
  }
  bool any = false;
  for (auto& part : form.parts) any |= decideIn(part, skills);
  return any;
}

} // namespace

const Form* bodyOf(const Form& definition) {
  const auto& parts = definition.parts;
  return parts[parts.size() - 2] == ":body" ? &parts.back() : nullptr;
}

bool declareOutcomes(Block& program) {
  Skills skills;
  for (auto& definition : program)
    if (const auto* body = bodyOf(definition)) {
      const auto& outcomes = skills[definition.parts[1].word] = outcomesOf(*body);
      declare(definition, outcomes);
    }
  bool any = false;
  for (auto& definition : program)
    if (bodyOf(definition)) any |= decideIn(definition.parts.back(), skills);
  return any;
}

} // namespace proskill::bridge::bt
