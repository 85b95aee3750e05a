#include "analysis/flow/domain/variables.h"

#include "analysis/flow/domain/numbers.h"
#include "analysis/names/types.h"
#include "syntax/tree/enumerate.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace proskill::analysis::flow {

namespace {

/// A domain is never empty, even if the text has no values.
Domain wordsOrOne(std::vector<std::string_view> words) {
  if (words.empty()) words.emplace_back();
  return Domain::ofWords(std::move(words));
}

Domain domainOf(const syntax::StateVariable& node, const std::vector<std::int64_t>& cuts) {
  if (!node.isNatural()) {
    std::vector<std::string_view> words;
    for (const syntax::Name& state : node.states) words.push_back(state.text);
    return wordsOrOne(std::move(words));
  }
  std::int64_t min = node.min ? wholeNumber(*node.min).value_or(0) : 0;
  std::int64_t max = node.max ? wholeNumber(*node.max).value_or(min) : min;
  return Domain::ofNumbers(min, std::max(min, max), cuts);
}

ValueSet initialOf(const syntax::Expr& init, const Domain& domain) {
  std::optional<std::int64_t> number =
      domain.isNumeric() ? wholeNumber(init) : domain.numberOf(init.name.text);
  ValueSet initial = number ? domain.touching({*number, *number}) : ValueSet();
  return initial.empty() ? domain.all() : initial;
}

ValueSet initialOf(const syntax::StateVariable& node, const Domain& domain) {
  ValueSet all = initialOf(node.init, domain);
  for (const syntax::Expr& other : node.otherInits) all |= initialOf(other, domain);
  return all;
}

/// Keeping the value is always allowed.
std::vector<ValueSet> allowedMoves(const syntax::StateVariable& node, const Domain& domain) {
  std::vector<ValueSet> allowed(domain.size());
  for (unsigned i = 0; i < domain.size(); ++i) allowed[i] = ValueSet::of(i);
  for (const syntax::Transition& move : node.transitions) {
    auto from = domain.numberOf(move.from.text);
    auto to = domain.numberOf(move.to.text);
    if (!from || !to) continue;
    ValueSet target = domain.touching({*to, *to});
    forEach(domain.touching({*from, *from}), [&](unsigned i) { allowed[i] |= target; });
  }
  return allowed;
}

std::vector<std::string_view> resultsOf(const syntax::Skill& skill) {
  std::vector<std::string_view> words{kNoResult};
  auto add = [&words](std::string_view tag) {
    if (!tag.empty() && std::ranges::find(words, tag) == words.end()) words.push_back(tag);
  };
  for (const auto& each : skill.successes) add(each.tag.text);
  for (const auto& each : skill.failures) add(each.tag.text);
  for (const auto& each : skill.invariants) add(each.tag.text);
  return words;
}

Domain domainOf(const syntax::Skill& skill, VariableKind kind) {
  if (kind == VariableKind::Result) return Domain::ofWords(resultsOf(skill));
  if (kind == VariableKind::Called) return Domain::ofWords({"idle", "called"});
  auto statuses = statusWords();
  return Domain::ofWords({statuses.begin(), statuses.end()});
}

} // namespace

Variables::Variables(const Program& program) : program(program) {
  std::vector<std::int64_t> cuts = numbersIn(program);
  for (std::size_t i = 0; i < program.stateVariables.all.size(); ++i) addStateVariable(i, cuts);
  for (VariableKind kind : {VariableKind::Status, VariableKind::Result, VariableKind::Called})
    addOfSkills(kind);
  firstOf[static_cast<std::size_t>(VariableKind::Used)] = static_cast<VariableId>(all.size());
  for (std::size_t i = 0; i < program.resources.all.size(); ++i) addResource(i);
}

void Variables::addStateVariable(std::size_t definition, const std::vector<std::int64_t>& cuts) {
  const syntax::StateVariable& node = program.stateVariables.all[definition].node();
  Variable variable{.kind = VariableKind::StateVariable,
                    .definition = definition,
                    .domain = domainOf(node, cuts)};
  variable.initial = initialOf(node, variable.domain);
  if (node.transitionsKind == syntax::Transitions::Listed) {
    variable.allowed = allowedMoves(node, variable.domain);
    variable.restricted = true;
  }
  variable.restricted |= node.isNatural();
  all.push_back(std::move(variable));
}

void Variables::addOfSkills(VariableKind kind) {
  firstOf[static_cast<std::size_t>(kind)] = static_cast<VariableId>(all.size());
  for (std::size_t i = 0; i < program.skills.all.size(); ++i)
    all.push_back({.kind = kind,
                   .definition = i,
                   .domain = domainOf(program.skills.all[i].node(), kind),
                   .initial = ValueSet::of(0)});
}

void Variables::addResource(std::size_t definition) {
  const auto& node = program.resources.all[definition].node();
  std::int64_t capacity = node.capacity ? wholeNumber(*node.capacity).value_or(1) : 1;
  std::vector<std::int64_t> cuts{capacity - 1};
  all.push_back({.kind = VariableKind::Used,
                 .definition = definition,
                 .domain = Domain::ofNumbers(0, std::max<std::int64_t>(capacity, 0), cuts),
                 .initial = ValueSet::of(0)});
}

VariableId Variables::of(VariableKind kind, std::size_t definition) const {
  return firstOf[static_cast<std::size_t>(kind)] + static_cast<VariableId>(definition);
}

std::string Variables::name(VariableId id) const {
  const Variable& variable = all[id];
  switch (variable.kind) {
  case VariableKind::StateVariable:
    return std::string(program.stateVariables.all[variable.definition].name());
  case VariableKind::Used: return std::string(program.resources.all[variable.definition].name());
  case VariableKind::Status:
    return fmt::format("{}.status", program.skills.all[variable.definition].name());
  case VariableKind::Result:
    return fmt::format("{}.res", program.skills.all[variable.definition].name());
  case VariableKind::Called: return std::string(program.skills.all[variable.definition].name());
  }
  return {};
}

std::string Variables::words(VariableId id, ValueSet values) const {
  const Domain& domain = all[id].domain;
  std::vector<std::string> parts;
  forEach(values, [&](unsigned i) {
    Span span = domain.at(i);
    if (!domain.isNumeric())
      for (std::int64_t n = span.first; n <= span.last; ++n) parts.emplace_back(domain.word(n));
    else if (span.first == span.last)
      parts.push_back(fmt::format("{}", span.first));
    else
      parts.push_back(fmt::format("{}..{}", span.first, span.last));
  });
  return syntax::enumerate(parts, " or ");
}

} // namespace proskill::analysis::flow
