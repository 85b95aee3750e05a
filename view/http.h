#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

/// As much of HTTP/1.1 (RFC 9112) as a page on this machine needs.
namespace proskill::view {

struct HttpRequest {
  std::string method;
  std::string target;                         ///< path and query, as sent
  std::map<std::string, std::string> headers; ///< names in small letters
  std::string body;

  /// Empty where there is none.
  [[nodiscard]] std::string_view header(const std::string& name) const;
};

struct HttpResponse {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  /// Beside those that every response has.
  std::map<std::string, std::string> headers;
};

/// The request line and the headers, up to but without the empty line. Nothing where it is none.
[[nodiscard]] std::optional<HttpRequest> parseHead(std::string_view head);

/// Larger bodies are refused.
constexpr std::size_t kLargestBody = std::size_t{1} << 20;

/// The length of the body in bytes; nothing where it is too large or the request does not say.
[[nodiscard]] std::optional<std::size_t> bodySize(const HttpRequest& request);

/// With its length, and with headers that keep it out of caches and of other pages.
/// To HEAD the length of the body is told, and the body is not sent.
[[nodiscard]] std::string toBytes(const HttpResponse& response, std::string_view method);

} // namespace proskill::view
