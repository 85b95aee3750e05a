#include "analysis/names/symbols.h"

#include "syntax/text/change.h"

#include <algorithm>

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
  case SymbolKind::Constant: return "constant";
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

SymbolTable::SymbolTable(const Program& program) : SymbolTable(program, std::nullopt) {}

SymbolTable::SymbolTable(const Program& program, const Program& before,
                         const SymbolTable& symbolsBefore)
    : SymbolTable(program, Before{before, symbolsBefore}) {}

SymbolTable::SymbolTable(const Program& program, const std::optional<Before>& before) {
  // estimated: four values, tags and inputs per definition
  const auto count = 5 * (program.stateVariables.all.size() + program.skills.all.size());
  symbols.reserve(count);
  byName.reserve(count);
  defineAll(SymbolKind::StateVariable, program.stateVariables);
  defineAll(SymbolKind::Event, program.events);
  defineAll(SymbolKind::Skill, program.skills);
  defineAll(SymbolKind::Resource, program.resources);
  defineAll(SymbolKind::Property, program.properties);
  defineAll(SymbolKind::Environment, program.environments);
  defineAll(SymbolKind::Constant, program.constants);
  ofDefinitions.resize(symbols.size());
  byName.resize(symbols.size());
  defineAllParts(SymbolKind::StateVariable, &Program::stateVariables, program, before);
  defineAllParts(SymbolKind::Skill, &Program::skills, program, before);
  defineAllParts(SymbolKind::Environment, &Program::environments, program, before);
}

SymbolId SymbolTable::find(SymbolKind kind, std::string_view name, SymbolId owner) const {
  if (owner == kNoSymbol) {
    const auto place = static_cast<std::size_t>(kind);
    if (place >= kTopLevelKinds) return kNoSymbol;
    const auto found = names[place].find(name);
    return found == names[place].end() ? kNoSymbol : found->second;
  }
  const auto all = partsByName(owner);
  const std::pair wanted(kind, name);
  const auto found =
      std::ranges::lower_bound(all, wanted, {}, [this](SymbolId id) { return keyOf(id); });
  return found != all.end() && keyOf(*found) == wanted ? *found : kNoSymbol;
}

SymbolTable::Ids SymbolTable::members(SymbolKind kind, SymbolId owner) const {
  const auto place = static_cast<std::size_t>(kind);
  if (owner == kNoSymbol) return place < kTopLevelKinds ? ofKinds[place] : Ids();
  const auto found = std::ranges::equal_range(parts(owner), kind, {},
                                              [this](SymbolId id) { return symbols[id].kind; });
  return {found.begin(), found.end()};
}

std::span<const SymbolId> SymbolTable::partsByName(SymbolId owner) const {
  const Ids all = parts(owner);
  return all.empty() ? std::span<const SymbolId>()
                     : std::span(byName).subspan(all.front(), all.size());
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

/// So that lookup finds the first of equal names.
void SymbolTable::sortParts(SymbolId owner) {
  const Ids parts = ofDefinitions[owner];
  byName.insert(byName.end(), parts.begin(), parts.end());
  std::ranges::sort(byName.end() - parts.size(), byName.end(), {},
                    [this](SymbolId id) { return std::pair(keyOf(id), id); });
}

void SymbolTable::noteDuplicates(SymbolId owner) {
  const auto all = partsByName(owner);
  for (auto first = all.begin(); first != all.end();) {
    auto next = std::next(first);
    for (; next != all.end() && keyOf(*first) == keyOf(*next); ++next)
      twice.push_back({*first, *next});
    first = next;
  }
}

void SymbolTable::defineInside(SymbolKind kind, const Name& name, Range extent, Owner owner) {
  if (!name) return;
  const Location at{symbols[owner.id].at.file, name.range.moved(owner.form.offset())};
  define({kind, name.text, at, extent.moved(owner.form.offset()), owner.id, 0});
}

template <class Node> void SymbolTable::defineAll(SymbolKind kind, const Table<Node>& table) {
  const SymbolId first = next();
  for (std::size_t i = 0; i < table.all.size(); ++i) {
    const Definition<Node>& it = table.all[i];
    const SymbolId id = next();
    define({kind, it.name(), it.at(it.form->name.range), it.form->range, kNoSymbol, i});
    if (it.name().empty()) continue;
    const auto [known, isNew] = names[static_cast<std::size_t>(kind)].try_emplace(it.name(), id);
    if (!isNew) twice.push_back({known->second, id});
  }
  ofKinds[static_cast<std::size_t>(kind)] = Ids(first, next());
}

template <class Node>
void SymbolTable::defineAllParts(SymbolKind kind, Table<Node> Program::*table,
                                 const Program& program, const std::optional<Before>& before) {
  const auto& all = (program.*table).all;
  static const std::vector<Definition<Node>> kNone;
  const auto& old = before ? (before->program.*table).all : kNone;
  const auto same = syntax::commonEnds(
      all, old, [](const auto& a, const auto& b) { return a.form->isSameRead(*b.form); });
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Owner owner{topLevel(kind, i), *all[i].form};
    const SymbolId first = next();
    const bool isInFront = i < same.front;
    if (isInFront || i >= all.size() - same.back) {
      const auto there = isInFront ? i : old.size() - (all.size() - i);
      copyParts(before->symbols, before->symbols.topLevel(kind, there), owner,
                owner.form.offset() - old[there].form->offset());
    } else {
      defineParts(all[i].nodeAsRead(), owner);
      ofDefinitions[owner.id] = Ids(first, next());
      sortParts(owner.id);
    }
    noteDuplicates(owner.id);
  }
}

void SymbolTable::copyParts(const SymbolTable& table, SymbolId ownerThere, Owner owner,
                            syntax::Offset by) {
  const Ids there = table.parts(ownerThere);
  const SymbolId shift = next() - *there.begin(); // may wrap around
  const FileId file = symbols[owner.id].at.file;
  for (const SymbolId id : there) {
    Symbol symbol = table[id];
    symbol.at = {file, symbol.at.range.moved(by)};
    symbol.extent = symbol.extent.moved(by);
    symbol.owner = owner.id;
    if (symbol.kind == SymbolKind::Label) labelsByName[symbol.name].push_back(next());
    define(symbol);
  }
  for (const SymbolId id : table.partsByName(ownerThere)) byName.push_back(id + shift);
  ofDefinitions[owner.id] = Ids(*there.begin() + shift, next());
}

void SymbolTable::defineParts(const syntax::StateVariable& variable, Owner owner) {
  for (const Name& value : variable.states)
    defineInside(SymbolKind::Value, value, value.range, owner);
}

void SymbolTable::defineParts(const syntax::Skill& skill, Owner owner) {
  for (const auto& it : skill.inputs)
    defineInside(SymbolKind::Parameter, withoutDollar(it.name), it.range, owner);
  for (const auto& it : skill.preconditions)
    defineInside(SymbolKind::PreconditionTag, it.tag, it.range, owner);
  for (const auto& it : skill.invariants)
    defineInside(SymbolKind::InvariantTag, it.tag, it.range, owner);
  for (const auto& it : skill.successes)
    defineInside(SymbolKind::SuccessTag, it.tag, it.range, owner);
  for (const auto& it : skill.failures)
    defineInside(SymbolKind::FailureTag, it.tag, it.range, owner);
  defineLabels(owner);
}

void SymbolTable::defineParts(const syntax::Environment&, Owner owner) { defineLabels(owner); }

void SymbolTable::defineLabels(Owner owner) {
  for (const syntax::Statement* label : owner.form.bodyIndexAsRead().labels) {
    if (!label->name) continue;
    labelsByName[label->name.text].push_back(next());
    defineInside(SymbolKind::Label, label->name, label->range, owner);
  }
}

} // namespace proskill::analysis
