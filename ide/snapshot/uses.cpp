#include "ide/snapshot/uses.h"

#include "ide/snapshot/symbol_key.h"
#include "syntax/tree/enumerate.h"

#include <fmt/format.h>

namespace proskill::ide {

namespace {

constexpr std::size_t kMostNames = 5;

} // namespace

bool isSetting(const View& view, const analysis::Occurrence& place) {
  if (place.role == analysis::Role::Write) return true;
  const auto& symbols = view.index().symbols();
  if (symbols[place.symbol].kind != analysis::SymbolKind::Value) return false;
  // in `(lamp On)` the value directly follows its variable
  const auto all = view.index().occurrences();
  const auto* self = view.index().at(place.at.file, place.at.range.begin);
  if (!self || self == all.data()) return false;
  const auto& before = *(self - 1);
  return before.role == analysis::Role::Write && before.at.file == place.at.file &&
         before.symbol == symbols[place.symbol].owner;
}

std::vector<analysis::SymbolId> usersOf(const View& view, analysis::SymbolId symbol,
                                        bool (*matters)(const View&, const analysis::Occurrence&)) {
  std::vector<analysis::SymbolId> users;
  for (const auto& place : view.index().occurrencesOf(symbol)) {
    if (place.role == analysis::Role::Definition || !matters(view, place)) continue;
    const auto user = definitionAround(view, place.at);
    // places are sorted, so those in one definition are adjacent
    const bool known = !users.empty() && users.back() == user;
    if (user != analysis::kNoSymbol && !known) users.push_back(user);
  }
  return users;
}

std::string enumerate(const View& view, const std::vector<analysis::SymbolId>& symbols) {
  const auto& all = view.index().symbols();
  const bool tooMany = symbols.size() > kMostNames;
  const auto shown = tooMany ? kMostNames - 1 : symbols.size();
  auto names = symbols | std::views::take(shown) | std::views::transform([&](auto symbol) {
                 return std::string_view(all[symbol].name);
               });
  if (!tooMany) return syntax::enumerateNames(names);
  std::string result;
  if (tooMany) result += fmt::format(" and {} more", symbols.size() - shown);
  return result;
}

} // namespace proskill::ide
