#include "view/http.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace proskill::view {

namespace {

std::string_view trim(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::string toLower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return out;
}

std::string_view reasonPhrase(int status) {
  switch (status) {
  case 200: return "OK";
  case 400: return "Bad Request";
  case 403: return "Forbidden";
  case 404: return "Not Found";
  case 405: return "Method Not Allowed";
  case 413: return "Content Too Large";
  default: return "Internal Server Error";
  }
}

/// Removes the next line from the text, and returns it without its end.
std::string_view takeLine(std::string_view& text) {
  const auto end = std::min(text.find("\r\n"), text.size());
  const auto line = text.substr(0, end);
  text.remove_prefix(std::min(end + 2, text.size()));
  return line;
}

/// Other readers of the line would take a lone CR or LF for its end.
bool hasControls(std::string_view line) {
  return std::ranges::any_of(line, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\t') || byte == 0x7f;
  });
}

/// `GET /path HTTP/1.1`
bool takeRequestLine(std::string_view line, HttpRequest& request) {
  const auto space = line.find(' ');
  const auto version = line.rfind(" HTTP/1.");
  if (hasControls(line) || space == 0 || space == line.npos || version == line.npos ||
      version <= space)
    return false;
  request.method = line.substr(0, space);
  request.target = line.substr(space + 1, version - space - 1);
  return request.target.starts_with('/');
}

/// Duplicate headers, such as two hosts, are rejected as an attack.
bool takeHeader(std::string_view line, HttpRequest& request) {
  const auto colon = line.find(':');
  if (hasControls(line) || colon == 0 || colon == line.npos) return false;
  return request.headers.emplace(toLower(line.substr(0, colon)), trim(line.substr(colon + 1)))
      .second;
}

} // namespace

std::string_view HttpRequest::header(const std::string& name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? std::string_view() : std::string_view(found->second);
}

std::optional<HttpRequest> parseHead(std::string_view head) {
  HttpRequest request;
  if (!takeRequestLine(takeLine(head), request)) return std::nullopt;
  while (!head.empty())
    if (!takeHeader(takeLine(head), request)) return std::nullopt;
  return request;
}

std::optional<std::size_t> bodySize(const HttpRequest& request) {
  if (!request.header("transfer-encoding").empty()) return std::nullopt;
  const auto text = request.header("content-length");
  if (text.empty()) return 0;
  std::size_t size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  if (error != std::errc() || end != text.data() + text.size() || size > kLargestBody)
    return std::nullopt;
  return size;
}

std::string toBytes(const HttpResponse& response, std::string_view method) {
  auto out = fmt::format("HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\n"
                         "Connection: close\r\nCache-Control: no-store\r\n"
                         "X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n"
                         "Cross-Origin-Resource-Policy: same-origin\r\n",
                         response.status, reasonPhrase(response.status), response.type,
                         response.body.size());
  for (const auto& [name, value] : response.headers) out += fmt::format("{}: {}\r\n", name, value);
  return out + "\r\n" + (method == "HEAD" ? "" : response.body);
}

} // namespace proskill::view
