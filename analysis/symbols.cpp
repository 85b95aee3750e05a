#include "analysis/symbols.h"

#include "analysis/walk.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <numeric>
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
  grow(count);
  defineAll(SymbolKind::StateVariable, program.stateVariables);
  defineAll(SymbolKind::Event, program.events);
  defineAll(SymbolKind::Skill, program.skills);
  defineAll(SymbolKind::Resource, program.resources);
  defineAll(SymbolKind::Property, program.properties);
  defineAll(SymbolKind::Environment, program.environments);
  parts.resize(symbols.size());
  defineAllParts(SymbolKind::StateVariable, program.stateVariables);
  defineAllParts(SymbolKind::Skill, program.skills);
  defineAllParts(SymbolKind::Environment, program.environments);
  ids.resize(symbols.size());
  std::iota(ids.begin(), ids.end(), SymbolId{0});
}

SymbolId SymbolTable::find(SymbolKind kind, std::string_view name, SymbolId owner) const {
  return names[slotOf(hashOf(kind, owner, name), kind, owner, name)].symbol;
}

std::span<const SymbolId> SymbolTable::members(SymbolKind kind, SymbolId owner) const {
  const auto place = static_cast<std::size_t>(kind);
  if (owner == kNoSymbol)
    return place < kTopLevelKinds ? std::span<const SymbolId>(definitions[place])
                                  : std::span<const SymbolId>();
  const auto [begin, end] = owner < parts.size() ? parts[owner] : Parts{};
  const auto all = std::span(ids).subspan(begin, end - begin);
  const auto first = std::ranges::find(all, kind, [&](SymbolId id) { return symbols[id].kind; });
  const auto last =
      std::find_if(first, all.end(), [&](SymbolId id) { return symbols[id].kind != kind; });
  return {first, last};
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

std::uint32_t SymbolTable::hashOf(SymbolKind kind, SymbolId owner, std::string_view name) {
  const std::size_t place = owner * std::size_t{31} + static_cast<std::size_t>(kind);
  const std::size_t hash = std::hash<std::string_view>{}(name) ^ (place * 0x9E3779B97F4A7C15u);
  return static_cast<std::uint32_t>(hash ^ (hash >> 32));
}

std::size_t SymbolTable::slotOf(std::uint32_t hash, SymbolKind kind, SymbolId owner,
                                std::string_view name) const {
  auto isIt = [&](const Slot& slot) {
    if (slot.hash != hash) return false;
    const Symbol& symbol = symbols[slot.symbol];
    return symbol.kind == kind && symbol.owner == owner && symbol.name == name;
  };
  const std::size_t mask = names.size() - 1;
  std::size_t at = hash & mask;
  while (names[at].symbol != kNoSymbol && !isIt(names[at])) at = (at + 1) & mask;
  return at;
}

/// Makes room for so many names.
void SymbolTable::grow(std::size_t count) {
  const auto old = std::exchange(names, std::vector<Slot>(std::bit_ceil(2 * count + 2)));
  const std::size_t mask = names.size() - 1;
  for (const Slot& slot : old) {
    if (slot.symbol == kNoSymbol) continue;
    std::size_t at = slot.hash & mask;
    while (names[at].symbol != kNoSymbol) at = (at + 1) & mask;
    names[at] = slot;
  }
}

/// The first of a name has it.
void SymbolTable::enter(SymbolId id) {
  const Symbol& symbol = symbols[id];
  if (2 * symbols.size() >= names.size()) grow(2 * symbols.size());
  const auto hash = hashOf(symbol.kind, symbol.owner, symbol.name);
  Slot& slot = names[slotOf(hash, symbol.kind, symbol.owner, symbol.name)];
  if (slot.symbol == kNoSymbol)
    slot = {id, hash};
  else
    twice.push_back({slot.symbol, id});
}

SymbolId SymbolTable::define(Symbol symbol) {
  const auto id = static_cast<SymbolId>(symbols.size());
  symbols.push_back(symbol);
  if (!symbol.name.empty()) enter(id);
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

template <class Node> void SymbolTable::defineAllParts(SymbolKind kind, const Table<Node>& table) {
  for (std::size_t i = 0; i < table.all.size(); ++i) {
    const SymbolId owner = topLevel(kind, i);
    parts[owner].begin = static_cast<SymbolId>(symbols.size());
    defineParts(table.all[i], owner);
    parts[owner].end = static_cast<SymbolId>(symbols.size());
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
