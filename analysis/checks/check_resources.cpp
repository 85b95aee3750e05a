#include "analysis/checks/checks.h"
#include "syntax/diagnostics/codes.h"

#include <map>

namespace proskill::analysis {

using syntax::Code;

namespace {

void checkCapacity(Context& context, const Definition<syntax::Resource>& resource) {
  const auto& capacity = resource->capacity;
  if (!capacity || capacity->kind == syntax::ExprKind::Missing) return;
  if (capacity->kind == syntax::ExprKind::Symbol) {
    Names(context, resource.file).use(SymbolKind::Constant, capacity->name, Role::Read);
    return;
  }
  const bool positive = capacity->kind == syntax::ExprKind::Number && !capacity->decimal &&
                        capacity->number.numerator >= 1;
  if (!positive)
    context.findings.report(Code::BadCapacity, resource.at(capacity->range), resource.name());
}

/// Checks the resources that a skill takes when it starts.
void checkTaken(Context& context, const Definition<syntax::Skill>& skill) {
  Names names(context, skill.file);
  std::map<std::string_view, syntax::Range> seen;
  for (const syntax::Name& resource : skill->resources) {
    names.use(SymbolKind::Resource, resource, Role::Mention);
    auto [first, isNew] = seen.try_emplace(resource.text, resource.range);
    if (!isNew && resource)
      context.findings.report(Code::RepeatedResource, skill.at(resource.range), resource.text)
          .related(skill.at(first->second), "first listed here");
  }
}

} // namespace

void checkResources(Context& context) {
  context.each(context.program.resources, [&](const auto& it) { checkCapacity(context, it); });
  context.each(context.program.skills, [&](const auto& skill) { checkTaken(context, skill); });
}

} // namespace proskill::analysis
