#include "analysis/checks/checks.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <map>
#include <span>

namespace proskill::analysis {

using syntax::Code;
using syntax::FieldUse;
using syntax::Name;

namespace {

using Keywords = std::span<const std::string_view>;

constexpr std::string_view kStateVariable[] = {":init", ":min", ":max", ":states", ":transitions"};
constexpr std::string_view kEvent[] = {":every", ":guard", ":effects"};
constexpr std::string_view kResource[] = {":capacity"};
constexpr std::string_view kEnvironment[] = {":body"};
constexpr std::string_view kProperty[] = {":after", ":before",  ":within",
                                          ":for",   ":lasting", ":fair"};
constexpr std::string_view kSkill[] = {
    ":input",     ":precondition", ":start",         ":invariant", ":time_interval",
    ":action",    ":interrupt",    ":interruptible", ":success",   ":failure",
    ":resources", ":monitor",      ":body"};

/// The fields of a definition: known, duplicate and missing ones.
class Fields {
public:
  Fields(Context& context, Location name, std::string what, const syntax::List<FieldUse>& uses,
         Keywords known, bool damaged)
      : context(context), name(name), what(std::move(what)), uses(uses) {
    auto isKnown = [&](const FieldUse& use) {
      return std::ranges::find(known, use.keyword.text) != known.end();
    };
    complete = !damaged && std::ranges::all_of(uses, isKnown);
    refuseRepeated();
  }

  [[nodiscard]] const FieldUse* find(std::string_view keyword) const {
    auto found =
        std::ranges::find(uses, keyword, [](const FieldUse& it) { return it.keyword.text; });
    return found == uses.end() ? nullptr : &*found;
  }
  [[nodiscard]] bool has(std::string_view keyword) const { return find(keyword) != nullptr; }

  void require(std::initializer_list<std::string_view> keywords) {
    std::string missing;
    for (std::string_view keyword : keywords)
      if (!has(keyword)) missing += (missing.empty() ? "`" : " and `") + std::string(keyword) + "`";
    if (!missing.empty()) report(Code::MissingField, missing);
  }

  /// Avoids consequential errors: no field is reported missing if a keyword is misspelt, or a
  /// parenthesis ends the definition early.
  void report(syntax::CodeFor<2> code, std::string_view detail = {}) {
    if (complete) context.findings.report(code, name, what, detail);
  }

  void refuse(std::string_view keyword, std::string_view why) {
    if (const FieldUse* use = find(keyword))
      context.findings.report(Code::MisplacedField, at(use->keyword), keyword, why);
  }

  [[nodiscard]] Location at(const Name& keyword) const { return {name.file, keyword.range}; }

private:
  void refuseRepeated() {
    std::map<std::string_view, const FieldUse*> seen;
    for (const FieldUse& use : uses) {
      auto [first, isNew] = seen.try_emplace(use.keyword.text, &use);
      if (!isNew)
        context.findings.report(Code::DuplicateField, at(use.keyword), use.keyword.text)
            .related(at(first->second->keyword), "first given here");
    }
  }

  Context& context;
  Location name;
  std::string what;
  const syntax::List<FieldUse>& uses;
  bool complete = true;
};

class FieldCheck {
public:
  explicit FieldCheck(Context& context) : context(context) {
    for (const auto& it : context.program.diagnostics)
      if (it.code == Code::UnclosedParenthesis || it.code == Code::SurplusParenthesis)
        damage.push_back(it.location);
  }

  void check() {
    const auto& program = context.program;
    context.each(program.stateVariables, [&](const auto& it) { stateVariable(it); });
    context.each(program.events,
                 [&](const auto& it) { fields("event", it, kEvent).require({":effects"}); });
    context.each(program.resources, [&](const auto& it) { fields("resource", it, kResource); });
    context.each(program.properties, [&](const auto& it) { property(it); });
    context.each(program.environments, [&](const auto& it) {
      fields("environment", it, kEnvironment).require({":body"});
    });
    context.each(program.skills, [&](const auto& it) { skill(it); });
  }

private:
  template <class Node>
  Fields fields(std::string_view kind, const Definition<Node>& definition, Keywords known) {
    const Name& name = definition->name;
    const bool cut = std::ranges::any_of(damage, [&](Location place) {
      const syntax::Range form = definition.form->range;
      return place.file == definition.file && form.begin <= place.range.begin &&
             place.range.begin <= form.end;
    });
    return Fields(context, definition.at(name ? name.range : definition.form->keyword.range),
                  std::string(kind) + (name ? " `" + std::string(name.text) + "`" : ""),
                  definition->fields, known, cut);
  }

  void stateVariable(const Definition<syntax::StateVariable>& variable) {
    Fields it = fields("state variable", variable, kStateVariable);
    if (it.has(":states")) {
      it.require({":init"});
      for (std::string_view keyword : {":min", ":max"})
        it.refuse(keyword, "is for naturals, and `:states` makes an enumeration");
    } else if (it.has(":min") || it.has(":max")) {
      it.require({":init", ":min", ":max"});
      it.refuse(":transitions", "is for enumerations, and `:min` and `:max` make a natural");
    } else {
      it.report(Code::NoDomain);
    }
  }

  void property(const Definition<syntax::Property>& property) {
    Fields it = fields("property", property, kProperty);
    if (property->within && property->within->upper)
      it.refuse(":fair", "selects among runs without end, and a property with an upper time limit "
                         "does not depend on them");
  }

  void skill(const Definition<syntax::Skill>& skill) {
    Fields it = fields("skill", skill, kSkill);
    const FieldUse* action = it.find(":action");
    const FieldUse* body = it.find(":body");
    if (action && body) {
      const bool actionFirst = action->range.begin < body->range.begin;
      context.findings
          .report(Code::ActionAndBody, it.at((actionFirst ? body : action)->keyword), skill.name())
          .related(it.at((actionFirst ? action : body)->keyword),
                   actionFirst ? "makes it a basic skill" : "makes it a composite skill");
    } else if (!action && !body) {
      it.report(Code::NeitherActionNorBody);
    } else if (action) {
      it.refuse(":monitor", "is for composite skills, and `:action` makes a basic one");
    }
    if (skill->unstoppable)
      it.refuse(":interrupt", "says how the skill is interrupted, and `:interruptible nil` that "
                              "it never is");
  }

  Context& context;
  std::vector<Location> damage; ///< missing or superfluous parentheses
};

} // namespace

void checkFields(Context& context) { FieldCheck(context).check(); }

} // namespace proskill::analysis
