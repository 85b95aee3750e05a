#include "tina/names.h"

#include "verify/graph/tina_names.h"

#include <algorithm>
#include <charconv>

namespace proskill::tina {

namespace {

using verify::System;

std::string_view unquoted(std::string_view name) {
  if (name.size() >= 2 && name.front() == '{' && name.back() == '}')
    return name.substr(1, name.size() - 2);
  return name;
}

/// Adds a spelling. One that two things share is ambiguous, and refers to neither.
template <class Table, class Thing> void enter(Table& table, std::string spelling, Thing thing) {
  auto [entry, added] = table.try_emplace(std::move(spelling), thing);
  if (!added) entry->second.reset();
}

template <class Table> auto find(const Table& table, std::string_view name) {
  const auto entry = table.find(unquoted(name));
  return entry == table.end() ? typename Table::mapped_type{} : entry->second;
}

/// `skill__takeoff_1_vx` with the process's name as in the model: `skill_takeoff_1_vx`.
std::string withPlainOwner(const std::string& name, const std::string& owner,
                           const std::string& plain) {
  return name.starts_with(owner) ? plain + name.substr(owner.size()) : name;
}

} // namespace

Names::Names(const System& system, const std::string& main) {
  std::vector<bool> isLocation(system.cells.size());
  for (verify::InstanceId i = 0; i < system.instances.size(); ++i) {
    const auto& instance = system.instances[i];
    isLocation[instance.location] = true;
    const auto spelled = tinaInstance(system, i);
    const bool same = spelled == instance.name;
    enter(instances, spelled, i);
    if (!same) enter(instances, instance.name, i);
    for (std::uint32_t at = 0; at < instance.locations.size(); ++at) {
      const auto place = tinaPlace(system, i, at);
      enter(places, place, Place{i, at});
      if (!same) enter(places, withPlainOwner(place, spelled, instance.name), Place{i, at});
    }
  }
  for (verify::CellId cell = 0; cell < system.cells.size(); ++cell) {
    if (isLocation[cell]) continue;
    const std::string name(unquoted(tinaVariable(system, cell, main)));
    enter(variables, name, cell);
    const auto end = name.find("_v");
    const auto owner = name.substr(0, end);
    std::string plain = owner;
    for (auto at = plain.find("__"); at != std::string::npos; at = plain.find("__", at + 1))
      plain.erase(at, 1);
    if (plain != owner) enter(variables, plain + name.substr(end), cell);
  }
}

std::optional<std::vector<Names::Part>> Names::transition(std::string_view name) const {
  std::vector<Part> found;
  if (!parts(unquoted(name), found)) return std::nullopt;
  std::ranges::sort(found);
  return found;
}

/// The prefix of a name whose `_t` is at `mark`.
std::optional<Names::Prefix> Names::partAt(std::string_view name, std::size_t mark) const {
  const auto instance = instances.find(name.substr(0, mark));
  if (instance == instances.end() || !instance->second) return std::nullopt;
  std::uint32_t leaf = 0;
  const auto* last = name.data() + name.size();
  const auto read = std::from_chars(name.data() + mark + 2, last, leaf);
  if (read.ec != std::errc{} || (read.ptr != last && *read.ptr != '_')) return std::nullopt;
  return Prefix{{*instance->second, leaf}, static_cast<std::size_t>(read.ptr - name.data())};
}

/// Splits `A_1_t0_B_2_t3` after each `_t` and number that follows an instance.
bool Names::parts(std::string_view name, std::vector<Part>& found) const {
  for (auto at = name.find("_t"); at != std::string_view::npos; at = name.find("_t", at + 1)) {
    const auto prefix = partAt(name, at);
    if (!prefix) continue;
    found.push_back(prefix->part);
    if (prefix->length == name.size()) return true;
    if (parts(name.substr(prefix->length + 1), found)) return true;
    found.pop_back();
  }
  return false;
}

std::vector<Names::Part> Names::partsWithin(std::string_view name) const {
  std::vector<Part> found;
  name = unquoted(name);
  while (!name.empty()) {
    std::optional<Prefix> prefix;
    for (auto at = name.find("_t"); at != std::string_view::npos && !prefix;
         at = name.find("_t", at + 1))
      prefix = partAt(name, at);
    if (prefix) found.push_back(prefix->part);
    const auto end = prefix ? prefix->length : name.find('_');
    name.remove_prefix(end >= name.size() ? name.size() : end + 1);
  }
  std::ranges::sort(found);
  return found;
}

std::optional<Names::Place> Names::place(std::string_view name) const { return find(places, name); }

std::optional<verify::CellId> Names::variable(std::string_view name) const {
  return find(variables, name);
}

} // namespace proskill::tina
