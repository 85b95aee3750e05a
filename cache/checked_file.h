#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace proskill::cache {

/// The content of a file that writeChecked() has written; null if it is missing or damaged.
[[nodiscard]] std::unique_ptr<nlohmann::json> readChecked(const std::filesystem::path& file);

/// Writes a file that begins with the digest of its rest, whole or not at all. Creates its
/// directory. A file larger than 16 MB would displace all others, so it is not written.
/// \return an error message, or nothing
[[nodiscard]] std::optional<std::string> writeChecked(const std::filesystem::path& file,
                                                      const nlohmann::json& content);

} // namespace proskill::cache
