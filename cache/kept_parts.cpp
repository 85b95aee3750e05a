#include "cache/kept_parts.h"

#include "cache/checked_file.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace proskill::cache {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostParts = 50'000;

} // namespace

KeptParts::KeptParts(std::filesystem::path from) : file(std::move(from)) {
  const auto json = readChecked(file);
  if (!json) return;
  try {
    last = json->at("model").get<std::string>();
    for (const auto& part : json->at("parts")) parts.emplace(part.get<std::string>(), false);
  } catch (const Json::exception&) {
    parts.clear();
  }
}

bool KeptParts::contains(const std::string& part) {
  const auto found = parts.find(part);
  if (found == parts.end()) return false;
  found->second = true;
  return true;
}

void KeptParts::insert(const std::string& part) {
  parts[part] = true;
  isSaved = false;
}

void KeptParts::setLastModel(const std::string& name) {
  isSaved = isSaved && last == name;
  last = name;
}

std::optional<std::string> KeptParts::save() {
  if (isSaved || file.empty()) return std::nullopt;
  isSaved = true;
  parts.merge(KeptParts(file).parts);
  if (parts.size() > kMostParts) std::erase_if(parts, [](const auto& it) { return !it.second; });
  Json all = Json::array();
  for (const auto& [part, isUsed] : parts) all.push_back(part);
  return writeChecked(file, {{"model", last}, {"parts", std::move(all)}});
}

} // namespace proskill::cache
