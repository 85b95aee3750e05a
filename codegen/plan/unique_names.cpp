#include "codegen/plan/unique_names.h"

#include "fiacre/syntax/words.h"

namespace proskill::codegen {

UniqueNames::UniqueNames(std::initializer_list<std::string_view> words)
    : taken(words.begin(), words.end()) {}

const std::string& UniqueNames::of(std::string_view kind,
                                   std::initializer_list<std::string_view> parts) {
  std::string key(kind);
  std::string preferred;
  for (const auto part : parts) {
    // names in ProSkill contain no dot, so keys are unique
    key.append(1, '.').append(part);
    if (part.empty()) continue;
    if (!preferred.empty()) preferred += '_';
    preferred += part;
  }
  if (const auto known = names.find(key); known != names.end()) return known->second;
  auto name = preferred;
  while (taken.contains(name) || fiacre::isReserved(name)) name += '_';
  if (name != preferred) renamed.push_back({preferred, name});
  taken.insert(name);
  return names.emplace(std::move(key), std::move(name)).first->second;
}

} // namespace proskill::codegen
