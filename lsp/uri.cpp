#include "lsp/uri.h"

#include <fmt/format.h>

#include <cctype>

namespace proskill::lsp {

namespace {

constexpr std::string_view kFile = "file://";

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  auto lower = std::tolower(static_cast<unsigned char>(c));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// A `%` that begins no escape stands for itself.
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

/// What RFC 3986 allows in a path without an escape.
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

} // namespace

std::optional<std::filesystem::path> toPath(std::string_view uri) {
  if (!uri.starts_with(kFile)) return std::nullopt;
  auto rest = uri.substr(kFile.size());
  auto slash = rest.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  return std::filesystem::path(decode(rest.substr(slash))).lexically_normal();
}

std::string toUri(const std::filesystem::path& path) {
  return std::string(kFile) + encode(path.generic_string());
}

std::string normalised(std::string_view uri) {
  auto path = toPath(uri);
  return path ? toUri(*path) : std::string(uri);
}

} // namespace proskill::lsp
