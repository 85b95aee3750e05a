#include "report/program_settings.h"

#include <nlohmann/json.hpp>

#include <fmt/format.h>
#include <sstream>

namespace proskill::report {

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

/// Reads settings with a SAX parser, to know the places of errors.
class Reader : public nlohmann::json_sax<Json> {
public:
  explicit Reader(const std::string& text) : text(text), stream(text) {}

  std::expected<Settings, SettingsMistake> read() && {
    if (Json::sax_parse(stream, this)) return std::move(settings);
    return std::unexpected(std::move(mistake));
  }

  bool null() override { return otherValue(); }
  bool number_integer(number_integer_t /*value*/) override { return otherValue(); }
  bool number_unsigned(number_unsigned_t /*value*/) override { return otherValue(); }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override {
    return otherValue();
  }
  bool binary(binary_t& /*value*/) override { return otherValue(); }
  bool start_array(std::size_t /*size*/) override { return otherValue(); }
  bool end_array() override { return true; }

  bool boolean(bool value) override {
    if (depth != 1 || name != "style") return otherValue();
    settings.style = value;
    return true;
  }

  bool string(string_t& value) override {
    if (depth == 1 && name == "$schema") return true;
    if (depth != 2) return otherValue();
    here = lastString();
    std::optional<Severity>& severity = settings.severities[code];
    severity.reset();
    if (value == "error") severity = Severity::Error;
    if (value == "warning") severity = Severity::Warning;
    if (value == "hint") severity = Severity::Hint;
    return severity || value == "off" || otherValue();
  }

  bool start_object(std::size_t /*size*/) override {
    if (depth == 2 || (depth == 1 && name != "severity")) return otherValue();
    ++depth;
    return true;
  }
  bool end_object() override {
    --depth;
    return true;
  }

  bool key(string_t& value) override {
    here = lastString();
    name = value;
    if (depth == 1) return isKnown() || fail("unknown setting `{}`", name);
    const syntax::CodeInfo* info = syntax::findCode(name);
    if (info) code = info->code;
    return info || fail("`{}` is not the code of a diagnostic", name);
  }

  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    auto end = static_cast<syntax::Offset>(std::min(position, text.size()));
    here = {end > 0 ? end - 1 : 0, end};
    std::string_view words = error.what();
    std::size_t reason = words.find(" - ");
    return fail("invalid JSON: {}",
                reason == std::string_view::npos ? words : words.substr(reason + 3));
  }

private:
  [[nodiscard]] bool isKnown() const {
    return name == "$schema" || name == "style" || name == "severity";
  }

  /// Reports a value that the key or the place does not allow.
  bool otherValue() {
    if (depth == 0)
      return fail("settings must be a JSON object, such as {}", "`{\"style\": true}`");
    if (depth == 2)
      return fail("the severity of `{}` must be `error`, `warning`, `hint` or `off`", name);
    if (name == "style") return fail("`{}` must be `true` or `false`", name);
    if (name == "severity")
      return fail("`{}` must be an object of codes with their severities", name);
    return fail("`{}` must be a string", name);
  }

  template <class Word> bool fail(fmt::format_string<const Word&> words, const Word& word) {
    mistake = {fmt::format(words, word), text, here};
    return false;
  }

  /// The string that was just read, with its quotes; it ends at the current position.
  [[nodiscard]] syntax::Range lastString() {
    auto end = static_cast<std::size_t>(stream.rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in));
    auto isEscaped = [this](std::size_t at) {
      std::size_t slashes = 0;
      while (at > slashes && text[at - slashes - 1] == '\\') ++slashes;
      return slashes % 2 == 1;
    };
    std::size_t begin = end - 1;
    while (begin > 0 && (text[begin - 1] != '"' || isEscaped(begin - 1))) --begin;
    return {static_cast<syntax::Offset>(begin > 0 ? begin - 1 : 0),
            static_cast<syntax::Offset>(end)};
  }

  const std::string& text;
  std::istringstream stream;
  Settings settings;
  SettingsMistake mistake;
  int depth = 0; ///< 1: in the object of settings; 2: in that of severities
  std::string name;
  syntax::Code code{};
  syntax::Range here; ///< of the key, or of the string after it
};

} // namespace

std::expected<Settings, SettingsMistake> parseSettings(const std::string& text) {
  return Reader(text).read();
}

ProgramSettings settingsFor(const analysis::FileSystem& files, const fs::path& root) {
  ProgramSettings result;
  auto file = nearest(files, root);
  if (!file) return result;
  result.file = *file;
  auto text = files.read(*file);
  auto settings =
      text ? parseSettings(*text) : std::unexpected(SettingsMistake{text.error(), {}, {}});
  if (settings)
    result.settings = std::move(*settings);
  else
    result.mistake = std::move(settings.error());
  return result;
}

} // namespace proskill::report
