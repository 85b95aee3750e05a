#include "view/http.h"
#include "fuzz/targets.h"

#include <algorithm>
#include <string>

namespace proskill::fuzz {

namespace {

using namespace view;

constexpr std::string_view kEndOfHead = "\r\n\r\n";

std::string written(const HttpRequest& request) {
  auto head = request.method + " " + request.target + " HTTP/1.1";
  for (const auto& [name, value] : request.headers) head += "\r\n" + name + ": " + value;
  return head;
}

void isSound(const HttpRequest& request) {
  expect(!request.method.empty() && request.method.find(' ') == std::string::npos,
         "a method is one word");
  expect(request.target.starts_with('/'), "a target is a path");
  for (const auto& [name, value] : request.headers) {
    expect(!name.empty() && name.find_first_of(":ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos,
           "a header's name is lower case");
    expect((name + value).find_first_of("\r\n") == std::string::npos, "a header is one line");
    expect(request.header(name) == value, "a header is found by its name");
  }
  expect(bodySize(request).value_or(0) <= kLargestBody, "a body is not too large");
}

void isReadAsWritten(const HttpRequest& request) {
  const auto again = parseHead(written(request));
  expect(again && again->method == request.method && again->target == request.target &&
             again->headers == request.headers,
         "a request is read as it was written");
}

/// The response has one header, followed by the whole body.
void isAnswered(std::string_view body) {
  for (const int status : {200, 404, 413, 599}) {
    const auto bytes = toBytes({status, "text/plain", std::string(body), {}}, "GET");
    expect(bytes.starts_with("HTTP/1.1 " + std::to_string(status) + " "), "the status comes first");
    const auto end = bytes.find(kEndOfHead);
    expect(std::string_view(bytes).substr(end + kEndOfHead.size()) == body, "the body comes last");
    expect(bytes.find("\r\nContent-Length: " + std::to_string(body.size()) + "\r\n") < end,
           "the length is the body's");
  }
}

} // namespace

void http(std::string_view bytes) {
  const auto end = std::min(bytes.find(kEndOfHead), bytes.size());
  isAnswered(bytes.substr(std::min(end + kEndOfHead.size(), bytes.size())));
  const auto request = parseHead(bytes.substr(0, end));
  if (!request) return;
  isSound(*request);
  isReadAsWritten(*request);
}

} // namespace proskill::fuzz
