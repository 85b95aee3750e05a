#include "ide/snapshot/symbol_key.h"

#include "ide/names/path.h"

#include <algorithm>

namespace proskill::ide {

namespace {

using analysis::kNoSymbol;
using analysis::SymbolId;
using analysis::SymbolKind;

bool isInSkill(SymbolKind kind) { return kind > SymbolKind::Value; }

/// Kinds of symbols that can contain this one. Labels occur in environments, too.
std::vector<SymbolKind> ownersOf(SymbolKind kind) {
  if (kind == SymbolKind::Value) return {SymbolKind::StateVariable};
  if (kind == SymbolKind::Label) return {SymbolKind::Skill, SymbolKind::Environment};
  return {SymbolKind::Skill};
}

/// The kind that the form defines, if any.
std::optional<SymbolKind> kindOf(const syntax::Form& form) {
  if (form.is<syntax::Constant>()) return SymbolKind::Constant;
  if (form.is<syntax::StateVariable>()) return SymbolKind::StateVariable;
  if (form.is<syntax::Event>()) return SymbolKind::Event;
  if (form.is<syntax::Skill>()) return SymbolKind::Skill;
  if (form.is<syntax::Resource>()) return SymbolKind::Resource;
  if (form.is<syntax::Property>()) return SymbolKind::Property;
  if (form.is<syntax::Environment>()) return SymbolKind::Environment;
  return std::nullopt;
}

} // namespace

SymbolKey keyOf(const analysis::SymbolTable& symbols, SymbolId symbol) {
  const auto& it = symbols[symbol];
  const auto owner = it.owner == kNoSymbol ? std::string_view() : symbols[it.owner].name;
  return {it.kind, std::string(it.name), std::string(owner)};
}

SymbolId findSymbol(const analysis::SymbolTable& symbols, const SymbolKey& key) {
  if (key.kind != SymbolKind::Value && !isInSkill(key.kind))
    return symbols.find(key.kind, key.name);
  for (auto kind : ownersOf(key.kind)) {
    const auto owner = symbols.find(kind, key.owner);
    if (owner == kNoSymbol) continue;
    const auto found = symbols.find(key.kind, key.name, owner);
    if (found != kNoSymbol) return found;
  }
  return kNoSymbol;
}

SymbolId symbolOf(const View& view, analysis::FileId file, const syntax::Form& form) {
  const auto kind = kindOf(form);
  if (!kind) return kNoSymbol;
  const auto& symbols = view.index().symbols();
  auto isIt = [&](SymbolId id) {
    return symbols[id].at.file == file && symbols[id].extent == form.range;
  };
  const auto first = symbols.find(*kind, form.name.text);
  if (first != kNoSymbol && isIt(first)) return first;
  const auto all = symbols.members(*kind, kNoSymbol);
  const auto found = std::ranges::find_if(all, isIt);
  return found == all.end() ? kNoSymbol : *found;
}

SymbolId definitionAround(const View& view, analysis::Location place) {
  const auto& document = view.program().files[place.file].document;
  const auto* form = formBefore(document, place.range.begin + 1);
  if (!form || place.range.begin > form->range.end) return kNoSymbol;
  return symbolOf(view, place.file, *form);
}

} // namespace proskill::ide
