#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

/// The part of HTTP/1.1 (RFC 9112) that a page on this machine needs.
namespace proskill::view {

struct HttpRequest {
  std::string method;
  std::string target;                         ///< path and query, as sent
  std::map<std::string, std::string> headers; ///< names in lower case
  std::string body;

  /// Empty if there is none.
  [[nodiscard]] std::string_view header(const std::string& name) const;
};

struct HttpResponse {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  /// In addition to those of every response.
  std::map<std::string, std::string> headers;
};

/// The request line and the headers, up to but without the empty line. Nothing if malformed.
[[nodiscard]] std::optional<HttpRequest> parseHead(std::string_view head);

/// Larger bodies are rejected.
constexpr std::size_t kLargestBody = std::size_t{1} << 20;

/// The length of the body in bytes; nothing if it is too large or missing.
[[nodiscard]] std::optional<std::size_t> bodySize(const HttpRequest& request);

/// With its length, and with headers that keep it out of caches and of other pages.
/// For HEAD the length of the body is sent, but not the body.
[[nodiscard]] std::string toBytes(const HttpResponse& response, std::string_view method);

} // namespace proskill::view
