#include "cli/settings.h"

#include "cli/disk.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string_view>

namespace proskill::cli {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using analysis::flow::Settings;
using syntax::Severity;

std::optional<fs::path> nearest(const fs::path& root) {
  std::error_code error;
  fs::path directory = fs::absolute(root, error).lexically_normal().parent_path();
  for (;; directory = directory.parent_path()) {
    fs::path file = directory / ".proskill.json";
    if (fs::is_regular_file(file, error)) return file;
    if (directory == directory.parent_path()) return std::nullopt;
  }
}

std::string quoted(const std::string& text) { return "`" + text + "`"; }

/// Adds one entry of `severity`; a sentence where it means nothing.
std::optional<std::string> addSeverity(const std::string& code, const Json& value,
                                       Settings& settings) {
  const syntax::CodeInfo* info = syntax::findCode(code);
  if (!info) return quoted(code) + " is no code of a diagnostic";
  const std::string word = value.is_string() ? value.get<std::string>() : std::string();
  std::optional<Severity>& severity = settings.severities[info->code];
  if (word == "error") severity = Severity::Error;
  if (word == "warning") severity = Severity::Warning;
  if (word == "hint") severity = Severity::Hint;
  if (severity || word == "off") return std::nullopt;
  return "the severity of " + quoted(code) + " is `error`, `warning`, `hint` or `off`";
}

std::expected<Settings, std::string> read(const Json& json) {
  if (!json.is_object()) return std::unexpected("it is no JSON object");
  Settings settings;
  for (const auto& [key, value] : json.items()) {
    if (key == "$schema") continue;
    if (key == "style" && value.is_boolean()) {
      settings.style = value.get<bool>();
    } else if (key == "severity" && value.is_object()) {
      for (const auto& [code, severity] : value.items())
        if (auto mistake = addSeverity(code, severity, settings)) return std::unexpected(*mistake);
    } else {
      return std::unexpected(quoted(key) + " is not understood here");
    }
  }
  return settings;
}

} // namespace

std::expected<Settings, std::string> settingsFor(const fs::path& root) {
  auto file = nearest(root);
  if (!file) return Settings{};
  auto in = [&](const std::string& mistake) {
    return std::unexpected(quoted(file->generic_string()) + ": " + mistake);
  };
  auto text = DiskFileSystem().read(*file);
  if (!text) return in(text.error());
  Json json = Json::parse(*text, nullptr, false);
  if (json.is_discarded()) return in("it is no JSON");
  auto settings = read(json);
  return settings ? settings : in(settings.error());
}

} // namespace proskill::cli
