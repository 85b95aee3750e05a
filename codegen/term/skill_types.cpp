#include "codegen/term/skill_types.h"

#include <algorithm>
#include <utility>

namespace proskill::codegen {
namespace {

using fiacre::Expr;

fiacre::Type unionOf(const std::vector<std::string>& constructors) {
  fiacre::Type type;
  type.kind = fiacre::TypeKind::Union;
  for (const auto& constructor : constructors) type.members.push_back({constructor, {}, ""});
  return type;
}

bool mayStrikeSome(const SkillPlan& skill) {
  bool found = skill.mayStrike();
  forEachThread(*skill.body,
                [&](const BodyAutomaton& thread) { found |= skill.mayStrike(thread); });
  return found;
}

} // namespace

SkillTypes::SkillTypes(Context& context) : context(context) {
  findCells();
  findFields();
}

void SkillTypes::findCells() {
  for (const auto& skill : context.plan.skills) {
    cells.push_back({context.names.cell(skill.name()), skill.root});
    if (!skill.body) continue;
    forEachThread(*skill.body, [&](const BodyAutomaton& thread) {
      if (!thread.path.empty()) cells.push_back({context.names.cell(thread.name), false});
    });
  }
}

void SkillTypes::findFields() {
  const auto any = [&](auto&& test) { return std::ranges::any_of(context.plan.skills, test); };
  fields.push_back(
      {"caller", namedType("skill_id"), name("None"), "who called it; None: it is free"});
  fields.push_back({"status", namedType("skill_status"), name("no_status"), "of the last call"});
  if (any([](const SkillPlan& skill) { return skill.resultIsRead; }))
    fields.push_back({"val", namedType("skill_result"), name("no_result"), "of the last call"});
  fields.push_back({"inv_active", boolType(), boolean(false), "it is running"});
  if (any([](const SkillPlan& skill) {
        return skill.mayBeStopped() || (skill.body && mayStrikeSome(skill));
      }))
    fields.push_back({"stop", boolType(), boolean(false), "it was asked to stop"});
  if (any([](const SkillPlan& skill) { return skill.mayLinger(); }))
    fields.push_back({"ending", boolType(), boolean(false),
                      "it ends early, and waits for what must not be stopped"});
  if (any([](const SkillPlan& skill) { return skill.shared(); }))
    fields.push_back(
        {"returned", boolType(), boolean(false), "it is done, its caller has not seen it"});
  if (any([](const SkillPlan& skill) { return skill.isWatchedAgain(); }))
    fields.push_back({"watched", boolType(), boolean(false), "its watchdog is watching it"});
  if (context.isPerformed()) {
    const auto last = context.arguments.last();
    fields.push_back({"ArgIndex", rangeType(0, last), number(0), "which call's arguments"});
  }
}

fiacre::Type SkillTypes::idType() const {
  return rangeType(0, static_cast<std::int64_t>(cells.size()) + 1);
}

std::vector<fiacre::Constant> SkillTypes::constants() const {
  std::vector<fiacre::Constant> all;
  std::int64_t index = 0;
  const auto add = [&](const std::string& name) {
    all.push_back({name, idType(), number(index++)});
  };
  for (const auto& cell : cells) add(cell.name);
  add("None");
  add("root");
  return all;
}

std::vector<fiacre::TypeDeclaration> SkillTypes::types() const {
  if (cells.empty()) return {};
  std::vector<fiacre::TypeDeclaration> all{
      {"skill_id", idType(), ""},
      {"skill_status", unionOf({"no_status", "success", "failure", "failed_inv", "interrupted"}),
       ""}};
  auto results = context.results;
  results.insert(results.begin(), "no_result");
  const bool needsResults =
      results.size() > 1 ||
      std::ranges::any_of(fields, [](const Field& field) { return field.name == "val"; });
  if (needsResults) all.push_back({"skill_result", unionOf(results), ""});
  fiacre::Type record;
  record.kind = fiacre::TypeKind::Record;
  for (const auto& field : fields)
    record.members.push_back({field.name, {field.type}, field.comment});
  all.push_back({"skill_record", std::move(record), "of each skill and each parallel branch"});
  fiacre::Type array;
  array.kind = fiacre::TypeKind::Array;
  array.size = static_cast<std::int64_t>(cells.size());
  array.element.push_back(namedType("skill_record"));
  all.push_back({"skill_array", std::move(array), ""});
  return all;
}

Expr SkillTypes::initial() const {
  const bool begins = !context.hasInitialChoice();
  Expr array;
  array.kind = fiacre::ExprKind::Array;
  for (const auto& cell : cells) {
    Expr record;
    record.kind = fiacre::ExprKind::Record;
    for (const auto& field : fields) {
      record.fields.push_back(field.name);
      const bool called = begins && cell.root && field.name == "caller";
      record.operands.push_back(called ? name("root") : field.initial);
    }
    array.operands.push_back(std::move(record));
  }
  return array;
}

} // namespace proskill::codegen
