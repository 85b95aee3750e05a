#include "lsp/program_settings.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string_view>

namespace proskill::lsp {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using analysis::flow::Settings;
using syntax::Severity;

std::optional<fs::path> nearest(const analysis::FileSystem& files, const fs::path& root) {
  std::error_code error;
  fs::path directory = fs::absolute(root, error).lexically_normal().parent_path();
  for (;; directory = directory.parent_path()) {
    fs::path file = directory / kSettingsFile;
    if (files.isFile(file)) return file;
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

std::expected<Settings, std::string> parseSettings(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return std::unexpected("it is no JSON");
  return read(json);
}

ProgramSettings settingsFor(const analysis::FileSystem& files, const fs::path& root) {
  ProgramSettings result;
  auto file = nearest(files, root);
  if (!file) return result;
  result.file = *file;
  auto text = files.read(*file);
  auto settings = text ? parseSettings(*text) : std::unexpected(text.error());
  if (settings)
    result.settings = std::move(*settings);
  else
    result.mistake = settings.error();
  return result;
}

} // namespace proskill::lsp
