#include "verify/sample/detours.h"

#include "verify/model/number_table.h"
#include "verify/state/run.h"

#include <unordered_map>

namespace proskill::verify {

std::vector<Detour> detoursOf(const System& system, std::vector<Word> state, const Steps& steps,
                              bool last) {
  std::vector<std::uint64_t> places{hashOfAll(state)};
  std::unordered_map<std::uint64_t, std::size_t> lastAt{{places[0], 0}};
  for (std::size_t i = 0; i + (last ? 0 : 1) < steps.size(); ++i) {
    if (fire(system, steps[i], state.data()) != Outcome::Done) break;
    places.push_back(hashOfAll(state));
    lastAt[places.back()] = i + 1;
  }
  std::vector<Detour> all;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t again = lastAt[places[i]];
    if (again > i) all.push_back({i, again});
    i = again;
  }
  return all;
}

Steps without(const std::vector<Detour>& some, const Steps& steps) {
  Steps rest;
  std::size_t from = 0;
  const auto keepUntil = [&](std::size_t until) {
    rest.insert(rest.end(), steps.begin() + static_cast<std::ptrdiff_t>(from),
                steps.begin() + static_cast<std::ptrdiff_t>(until));
  };
  for (const auto& [begin, end] : some) {
    keepUntil(begin);
    from = end;
  }
  keepUntil(steps.size());
  return rest;
}

} // namespace proskill::verify
