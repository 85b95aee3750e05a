#include "analysis/symbols.h"

#include "analysis/walk.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <tuple>
#include <utility>

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

SymbolTable::SymbolTable(const Program& program) {
  // About four values, tags and inputs to each.
  const auto count = 5 * (program.stateVariables.all.size() + program.skills.all.size());
  symbols.reserve(count);
  defineAll(SymbolKind::StateVariable, program.stateVariables);
  defineAll(SymbolKind::Event, program.events);
  defineAll(SymbolKind::Skill, program.skills);
  defineAll(SymbolKind::Resource, program.resources);
  defineAll(SymbolKind::Property, program.properties);
  defineAll(SymbolKind::Environment, program.environments);
  ofDefinitions.resize(symbols.size());
  defineAllParts(SymbolKind::StateVariable, program.stateVariables);
  defineAllParts(SymbolKind::Skill, program.skills);
  defineAllParts(SymbolKind::Environment, program.environments);
  ids.resize(symbols.size());
  std::iota(ids.begin(), ids.end(), SymbolId{0});
  byName = ids;
  for (SymbolId owner = 0; owner < ofDefinitions.size(); ++owner) sortParts(owner);
}

SymbolId SymbolTable::find(SymbolKind kind, std::string_view name, SymbolId owner) const {
  if (owner == kNoSymbol) {
    const auto place = static_cast<std::size_t>(kind);
    if (place >= kTopLevelKinds) return kNoSymbol;
    const auto found = names[place].find(name);
    return found == names[place].end() ? kNoSymbol : found->second;
  }
  const auto [begin, end] = owner < ofDefinitions.size() ? ofDefinitions[owner] : Parts{};
  const auto all = std::span(byName).subspan(begin, end - begin);
  const auto wanted = std::tuple(kind, name);
  const auto found = std::ranges::lower_bound(all, wanted, {}, [this](SymbolId id) {
    return std::tuple(symbols[id].kind, symbols[id].name);
  });
  const bool isIt =
      found != all.end() && symbols[*found].kind == kind && symbols[*found].name == name;
  return isIt ? *found : kNoSymbol;
}

std::span<const SymbolId> SymbolTable::members(SymbolKind kind, SymbolId owner) const {
  const auto place = static_cast<std::size_t>(kind);
  if (owner == kNoSymbol)
    return place < kTopLevelKinds ? std::span<const SymbolId>(definitions[place])
                                  : std::span<const SymbolId>();
  const auto all = parts(owner);
  const auto first = std::ranges::find(all, kind, [&](SymbolId id) { return symbols[id].kind; });
  const auto last =
      std::find_if(first, all.end(), [&](SymbolId id) { return symbols[id].kind != kind; });
  return {first, last};
}

std::span<const SymbolId> SymbolTable::parts(SymbolId owner) const {
  const auto [begin, end] = owner < ofDefinitions.size() ? ofDefinitions[owner] : Parts{};
  return std::span(ids).subspan(begin, end - begin);
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
  symbols.push_back(symbol);
  return static_cast<SymbolId>(symbols.size() - 1);
}

/// So that the first of a name comes first; those after it are noted.
void SymbolTable::sortParts(SymbolId owner) {
  const auto [begin, end] = ofDefinitions[owner];
  const auto all = std::span(byName).subspan(begin, end - begin);
  auto key = [this](SymbolId id) { return std::tuple(symbols[id].kind, symbols[id].name, id); };
  std::ranges::sort(all, {}, key);
  auto isSame = [this](SymbolId a, SymbolId b) {
    return symbols[a].kind == symbols[b].kind && symbols[a].name == symbols[b].name;
  };
  for (auto first = all.begin(); first != all.end();) {
    auto next = std::next(first);
    for (; next != all.end() && isSame(*first, *next); ++next) twice.push_back({*first, *next});
    first = next;
  }
}

void SymbolTable::defineInside(SymbolKind kind, const Name& name, Range extent, SymbolId owner) {
  if (name) define({kind, name.text, {symbols[owner].at.file, name.range}, extent, owner, 0});
}

template <class Node> void SymbolTable::defineAll(SymbolKind kind, const Table<Node>& table) {
  auto& ids = definitions[static_cast<std::size_t>(kind)];
  for (std::size_t i = 0; i < table.all.size(); ++i) {
    const Definition<Node>& it = table.all[i];
    const auto id = define({kind, it.name(), it.at(it->name.range), it.form->range, kNoSymbol, i});
    ids.push_back(id);
    if (it.name().empty()) continue;
    const auto [first, isNew] = names[static_cast<std::size_t>(kind)].try_emplace(it.name(), id);
    if (!isNew) twice.push_back({first->second, id});
  }
}

template <class Node> void SymbolTable::defineAllParts(SymbolKind kind, const Table<Node>& table) {
  for (std::size_t i = 0; i < table.all.size(); ++i) {
    const SymbolId owner = topLevel(kind, i);
    ofDefinitions[owner].begin = static_cast<SymbolId>(symbols.size());
    defineParts(table.all[i], owner);
    ofDefinitions[owner].end = static_cast<SymbolId>(symbols.size());
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

void SymbolTable::defineParts(const Definition<syntax::Environment>& environment, SymbolId owner) {
  defineLabels(environment->body, owner);
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
