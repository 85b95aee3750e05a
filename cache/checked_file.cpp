#include "cache/checked_file.h"

#include "disk/disk.h"
#include "disk/output.h"
#include "syntax/text/source.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace proskill::cache {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kDigits = 32;
constexpr std::size_t kLargestFile = std::size_t{16} << 20;

} // namespace

std::unique_ptr<Json> readChecked(const std::filesystem::path& file) {
  const auto bytes = disk::DiskFileSystem().read(file);
  if (!bytes || bytes->size() < kDigits) return nullptr;
  const auto body = std::string_view(*bytes).substr(kDigits);
  if (syntax::digestOf(body) != std::string_view(*bytes).substr(0, kDigits)) return nullptr;
  Json content = Json::from_cbor(body, true, false);
  return content.is_discarded() ? nullptr : std::make_unique<Json>(std::move(content));
}

std::optional<std::string> writeChecked(const std::filesystem::path& file, const Json& content) {
  const auto directory = file.parent_path();
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    return fmt::format("the directory `{}` cannot be made: {}", directory.string(),
                       error.message());
  std::string body;
  Json::to_cbor(content, body);
  if (body.size() > kLargestFile) return std::nullopt;
  return disk::writeFile(file, syntax::digestOf(body) + body);
}

} // namespace proskill::cache
