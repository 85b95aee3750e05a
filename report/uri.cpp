#include "report/uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace proskill::report {

namespace {

constexpr std::string_view kFile = "file://";

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  auto lower = std::tolower(static_cast<unsigned char>(c));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// Decodes a URI. A `%` without a valid escape is kept.
std::string decode(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    bool escape = text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 &&
                  hexDigit(text[i + 2]) >= 0;
    result +=
        escape ? static_cast<char>(hexDigit(text[i + 1]) * 16 + hexDigit(text[i + 2])) : text[i];
    if (escape) i += 2;
  }
  return result;
}

/// Whether RFC 3986 allows the character in a path without an escape.
bool isUnescaped(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("-._~/!$&'()*+,;=@").find(c) != std::string_view::npos;
}

std::string encode(std::string_view text) {
  std::string result;
  for (char c : text)
    result +=
        isUnescaped(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return result;
}

/// The scheme in a path that `pathOf` made of a URI: "untitled" in `/untitled:Untitled-1`. No
/// directory has a colon at this place; a single letter is a drive.
std::string_view schemeIn(std::string_view path) {
  const auto end = path.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789+-.", 1);
  const bool found = end != std::string_view::npos && end > 2 && path[end] == ':';
  return found ? path.substr(1, end - 1) : std::string_view();
}

} // namespace

std::optional<std::filesystem::path> toPath(std::string_view uri) {
  if (!uri.starts_with(kFile)) return std::nullopt;
  auto rest = uri.substr(kFile.size());
  auto slash = rest.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  return std::filesystem::path(decode(rest.substr(slash))).lexically_normal();
}

/// Restores a URI of another scheme that `pathOf` has made a path of.
std::string toUri(const std::filesystem::path& path) {
  if (const auto scheme = schemeIn(path.native()); !scheme.empty()) return path.native().substr(1);
  return std::string(kFile) + encode(path.generic_string());
}

std::string toUriReference(const std::filesystem::path& path) {
  return std::string(path.is_absolute() ? kFile : "") + encode(path.generic_string());
}

std::optional<std::filesystem::path> toCellPath(std::string_view uri) {
  const auto colon = uri.find(':');
  if (uri.find('#') == std::string_view::npos || colon == std::string_view::npos) return {};
  auto rest = uri.substr(colon + 1);
  if (rest.starts_with("//")) rest = rest.substr(std::min(rest.find('/', 2), rest.size()));
  const auto file = rest.starts_with('/') ? rest.substr(0, rest.find_first_of("?#")) : "";
  const auto path = std::filesystem::path("/" + decode(file)).lexically_normal();
  auto name = path.filename().string() + decode(file.empty() ? uri : rest.substr(file.size()));
  std::ranges::replace_if(
      name, [](char c) { return std::string_view("/\"\\%\r\n").contains(c); }, '_');
  return path.parent_path() / name;
}

std::string normalised(std::string_view uri) {
  auto path = toPath(uri);
  return path ? toUri(*path) : std::string(uri);
}

} // namespace proskill::report
