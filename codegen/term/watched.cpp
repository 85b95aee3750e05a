#include "codegen/term/watched.h"

#include "codegen/term/inputs.h"
#include "fiacre/print/print.h"

namespace proskill::codegen {

namespace {

using Words = std::map<std::string, std::string>;

Words shownValues(Context& context, const syntax::StateVariable& variable) {
  Words words;
  for (const auto& state : variable.states)
    words[context.names.value(variable.name.text, state.text)] = state.text;
  return words;
}

/// A truth value is shown as it is.
Words shownValues(Context& context, const syntax::Input& input) {
  const auto* type = context.typeOf(input);
  return type ? shownValues(context, *type) : Words();
}

Words resultsOf(Context& context, const syntax::Skill& skill) {
  Words words;
  const auto add = [&](const auto& tagged, std::string_view status) {
    for (const auto& each : tagged)
      if (each.tag)
        words[context.names.result(skill.name.text, status, each.tag.text)] = each.tag.text;
  };
  add(skill.successes, "success");
  add(skill.failures, "failure");
  add(skill.invariants, "failed_inv");
  return words;
}

} // namespace

std::vector<fiacre::Watched> watchedVariables(Context& context) {
  std::vector<fiacre::Watched> all;
  for (const auto& variable : context.program.stateVariables.all)
    all.push_back({context.names.variable(variable.name()), std::string(variable.name()),
                   shownValues(context, variable.node())});
  for (const auto& skill : context.plan.skills) {
    const auto add = [&](std::string_view field, std::string_view member, Words words) {
      all.push_back({fiacre::printLvalue(context.cellField(skill.name(), field)),
                     std::string(skill.name()) + "." + std::string(member), std::move(words)});
    };
    add("status", "status", {});
    if (skill.resultIsRead) add("val", "res", resultsOf(context, skill.skill()));
    for (const auto* input : skill.inputs)
      all.push_back({context.names.input(skill.name(), input->name.text),
                     shownInput(skill.name(), input->name.text), shownValues(context, *input)});
  }
  for (const auto& resource : context.program.resources.all)
    all.push_back(
        {context.names.used(resource.name()), std::string(resource.name()) + " in use", {}});
  return all;
}

} // namespace proskill::codegen
