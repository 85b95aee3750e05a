#include "codegen/watched.h"

#include "fiacre/print.h"

namespace proskill::codegen {

std::vector<fiacre::Watched> watchedVariables(Context& context) {
  std::vector<fiacre::Watched> all;
  for (const auto& variable : context.program.stateVariables.all)
    all.push_back({context.names.variable(variable.name()), std::string(variable.name())});
  for (const auto& skill : context.plan.skills) {
    const auto add = [&](std::string_view field, std::string_view member) {
      all.push_back({fiacre::printLvalue(context.cellField(skill.name(), field)),
                     std::string(skill.name()) + "." + std::string(member)});
    };
    add("status", "status");
    if (skill.resultIsRead) add("val", "res");
  }
  for (const auto& resource : context.program.resources.all)
    all.push_back({context.names.used(resource.name()), std::string(resource.name()) + " in use"});
  return all;
}

} // namespace proskill::codegen
