#include "cli/http.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::cli {

namespace {

std::string_view trim(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::string small(std::string_view text) {
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

} // namespace

std::string_view HttpRequest::header(const std::string& name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? std::string_view() : std::string_view(found->second);
}

std::optional<HttpRequest> parseHead(std::string_view head) {
  HttpRequest request;
  bool first = true;
  while (!head.empty()) {
    const auto end = std::min(head.find("\r\n"), head.size());
    const auto line = head.substr(0, end);
    head.remove_prefix(std::min(end + 2, head.size()));
    if (first) {
      const auto space = line.find(' ');
      const auto version = line.rfind(" HTTP/1.");
      if (space == std::string_view::npos || version == std::string_view::npos || version <= space)
        return std::nullopt;
      request.method = line.substr(0, space);
      request.target = line.substr(space + 1, version - space - 1);
      first = false;
      continue;
    }
    const auto colon = line.find(':');
    if (colon == 0 || colon == std::string_view::npos) return std::nullopt;
    // Two of one name, such as two hosts, are a trick.
    if (!request.headers.emplace(small(line.substr(0, colon)), trim(line.substr(colon + 1))).second)
      return std::nullopt;
  }
  if (first || request.target.empty() || request.target.front() != '/') return std::nullopt;
  return request;
}

std::string toBytes(const HttpResponse& response) {
  auto out = fmt::format("HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\n"
                         "Connection: close\r\nCache-Control: no-store\r\n"
                         "X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n"
                         "Cross-Origin-Resource-Policy: same-origin\r\n",
                         response.status, reasonPhrase(response.status), response.type,
                         response.body.size());
  for (const auto& [name, value] : response.headers) out += fmt::format("{}: {}\r\n", name, value);
  return out + "\r\n" + response.body;
}

} // namespace proskill::cli
