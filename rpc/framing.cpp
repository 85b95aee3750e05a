#include "rpc/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace proskill::rpc {

namespace {

constexpr std::string_view kHeaderEnd = "\r\n\r\n";
constexpr std::string_view kLength = "content-length:";
/// In bytes. Anything longer is not a header.
constexpr std::size_t kLongestHeader = 8192;

bool startsWithIgnoringCase(std::string_view text, std::string_view lower) {
  return text.size() >= lower.size() &&
         std::ranges::equal(text.substr(0, lower.size()), lower, [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == b;
         });
}

/// The number of a `Content-Length:` line; nullopt for any other line.
std::optional<std::size_t> lengthIn(std::string_view line) {
  if (!startsWithIgnoringCase(line, kLength)) return std::nullopt;
  auto digits = line.substr(kLength.size());
  digits.remove_prefix(std::min(digits.find_first_not_of(" \t"), digits.size()));
  std::size_t value = 0;
  auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  bool whole =
      digits.substr(static_cast<std::size_t>(end - digits.data())).find_first_not_of(" \t") ==
      std::string_view::npos;
  if (error != std::errc() || !whole) return std::nullopt;
  return value;
}

std::optional<std::size_t> lengthInHeader(std::string_view header) {
  while (!header.empty()) {
    auto end = std::min(header.find("\r\n"), header.size());
    if (auto length = lengthIn(header.substr(0, end))) return length;
    header.remove_prefix(std::min(end + 2, header.size()));
  }
  return std::nullopt;
}

/// The next position at which a header may begin, possibly with its first bytes only; the length of
/// the text if there is none.
std::size_t nextHeader(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    auto here = text.substr(at);
    if (startsWithIgnoringCase(here, kLength.substr(0, here.size()))) return at;
  }
  return text.size();
}

} // namespace

void FrameReader::feed(std::string_view bytes) {
  if (position > 0 && position >= buffer.size() / 2) {
    buffer.erase(0, position);
    position = 0;
  }
  buffer.append(bytes);
}

std::optional<Frame> FrameReader::next() {
  skip();
  if (toSkip > 0) return std::nullopt;
  if (bodyLength) return readBody();
  return readHeader();
}

/// Discards the received bytes of a body that is too long.
void FrameReader::skip() {
  auto now = std::min(toSkip, buffer.size() - position);
  position += now;
  toSkip -= now;
}

/// Reads a header, and its body if it has arrived.
std::optional<Frame> FrameReader::readHeader() {
  // also past what looked like a header when fewer of its bytes had arrived
  if (lost) position += nextHeader(std::string_view(buffer).substr(position));
  auto pending = std::string_view(buffer).substr(position);
  constexpr auto kLongest = kLongestHeader + kHeaderEnd.size();
  auto end = pending.substr(0, kLongest).find(kHeaderEnd);
  if (end == std::string_view::npos) {
    if (pending.size() < kLongest) return std::nullopt;
    return resynchronise("no header in the first bytes of a message");
  }
  auto length = lengthInHeader(pending.substr(0, end));
  if (!length) return resynchronise("a header without a Content-Length");
  lost = false;
  position += end + kHeaderEnd.size();
  if (*length > limit) {
    toSkip = *length;
    return FramingError{
        fmt::format("a message of {} bytes; the longest that is read has {}", *length, limit)};
  }
  bodyLength = length;
  return readBody();
}

std::optional<Frame> FrameReader::readBody() {
  if (buffer.size() - position < *bodyLength) return std::nullopt;
  std::string body = buffer.substr(position, *bodyLength);
  position += *bodyLength;
  bodyLength.reset();
  return body;
}

/// Continues at the next position that may be a header.
Frame FrameReader::resynchronise(std::string message) {
  ++position;
  lost = true;
  return FramingError{std::move(message)};
}

std::string header(std::size_t length) { return fmt::format("Content-Length: {}\r\n\r\n", length); }

std::string frame(std::string_view body) { return header(body.size()).append(body); }

} // namespace proskill::rpc
