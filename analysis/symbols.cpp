#include "analysis/symbols.h"

#include "analysis/walk.h"

#include <cassert>
#include <functional>

namespace proskill::analysis {

using syntax::Name;
using syntax::Range;

std::string_view words(SymbolKind kind) {
  switch (kind) {
  case SymbolKind::StateVariable: return "state variable";
  case SymbolKind::Event: return "event";
  case SymbolKind::Skill: return "skill";
  case SymbolKind::Resource: return "resource";
  case SymbolKind::Property: return "property";
  case SymbolKind::Environment: return "environment";
  case SymbolKind::Value: return "value";
  case SymbolKind::Parameter: return "input";
  case SymbolKind::Label: return "label";
  case SymbolKind::PreconditionTag:
  case SymbolKind::InvariantTag:
  case SymbolKind::SuccessTag:
  case SymbolKind::FailureTag: return "tag";
  }
  return {};
}

Name withoutDollar(Name name) {
  if (!name.text.starts_with('$')) return name;
  return {name.text.substr(1), {name.range.begin + 1, name.range.end}};
}

std::size_t SymbolTable::Hash::operator()(const Key& key) const {
  const std::size_t place = key.owner * std::size_t{31} + static_cast<std::size_t>(key.kind);
  return std::hash<std::string_view>{}(key.name) ^ (place * 0x9E3779B97F4A7C15u);
}

SymbolTable::SymbolTable(const Program& program) {
  // About four values, tags and inputs to each: growing the tables one by one costs a third of all.
  const auto count = 5 * (program.stateVariables.all.size() + program.skills.all.size());
  symbols.reserve(count);
  byName.reserve(count);
  byPlace.reserve(count);
  defineAll(SymbolKind::StateVariable, program.stateVariables);
  defineAll(SymbolKind::Event, program.events);
  defineAll(SymbolKind::Skill, program.skills);
  defineAll(SymbolKind::Resource, program.resources);
  defineAll(SymbolKind::Property, program.properties);
  defineAll(SymbolKind::Environment, program.environments);
  const auto& variables = program.stateVariables.all;
  for (std::size_t i = 0; i < variables.size(); ++i)
    defineParts(variables[i], topLevel(SymbolKind::StateVariable, i));
  const auto& skills = program.skills.all;
  for (std::size_t i = 0; i < skills.size(); ++i)
    defineParts(skills[i], topLevel(SymbolKind::Skill, i));
  const auto& environments = program.environments.all;
  for (std::size_t i = 0; i < environments.size(); ++i)
    defineLabels(environments[i]->body, topLevel(SymbolKind::Environment, i));
}

SymbolId SymbolTable::find(SymbolKind kind, std::string_view name, SymbolId owner) const {
  auto found = byName.find({kind, owner, name});
  return found == byName.end() ? kNoSymbol : found->second;
}

std::span<const SymbolId> SymbolTable::members(SymbolKind kind, SymbolId owner) const {
  auto found = byPlace.find({kind, owner, {}});
  if (found == byPlace.end()) return {};
  return found->second;
}

SymbolId SymbolTable::findResult(std::string_view tag, SymbolId skill) const {
  for (SymbolKind kind : {SymbolKind::SuccessTag, SymbolKind::FailureTag, SymbolKind::InvariantTag})
    if (SymbolId found = find(kind, tag, skill); found != kNoSymbol) return found;
  return kNoSymbol;
}

std::span<const SymbolId> SymbolTable::labels(std::string_view name) const {
  auto found = labelsByName.find(name);
  if (found == labelsByName.end()) return {};
  return found->second;
}

SymbolId SymbolTable::define(Symbol symbol) {
  const auto id = static_cast<SymbolId>(symbols.size());
  if (!symbol.name.empty()) {
    auto [place, isNew] = byName.try_emplace({symbol.kind, symbol.owner, symbol.name}, id);
    if (!isNew) twice.push_back({place->second, id});
  }
  byPlace[{symbol.kind, symbol.owner, {}}].push_back(id);
  symbols.push_back(symbol);
  return id;
}

void SymbolTable::defineInside(SymbolKind kind, const Name& name, Range extent, SymbolId owner) {
  if (name) define({kind, name.text, {symbols[owner].at.file, name.range}, extent, owner, 0});
}

template <class Node> void SymbolTable::defineAll(SymbolKind kind, const Table<Node>& table) {
  auto& ids = definitions[static_cast<std::size_t>(kind)];
  for (std::size_t i = 0; i < table.all.size(); ++i) {
    const Definition<Node>& it = table.all[i];
    ids.push_back(define({kind, it.name(), it.at(it->name.range), it.form->range, kNoSymbol, i}));
  }
}

void SymbolTable::defineParts(const Definition<syntax::StateVariable>& variable, SymbolId owner) {
  for (const Name& value : variable->states)
    defineInside(SymbolKind::Value, value, value.range, owner);
}

void SymbolTable::defineParts(const Definition<syntax::Skill>& skill, SymbolId owner) {
  for (const auto& it : skill->inputs)
    defineInside(SymbolKind::Parameter, withoutDollar(it.name), it.range, owner);
  for (const auto& it : skill->preconditions)
    defineInside(SymbolKind::PreconditionTag, it.tag, it.range, owner);
  for (const auto& it : skill->invariants)
    defineInside(SymbolKind::InvariantTag, it.tag, it.range, owner);
  for (const auto& it : skill->successes)
    defineInside(SymbolKind::SuccessTag, it.tag, it.range, owner);
  for (const auto& it : skill->failures)
    defineInside(SymbolKind::FailureTag, it.tag, it.range, owner);
  if (skill->body) defineLabels(*skill->body, owner);
}

void SymbolTable::defineLabels(const syntax::Block& block, SymbolId owner) {
  forEachStatement(block, [&](const syntax::Statement& statement) {
    if (statement.kind != syntax::StatementKind::Label || !statement.name) return;
    const auto id = static_cast<SymbolId>(symbols.size());
    defineInside(SymbolKind::Label, statement.name, statement.range, owner);
    labelsByName[statement.name.text].push_back(id);
  });
}

} // namespace proskill::analysis
