#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

/// The form of messages in a stream of bytes: a header with `Content-Length`, an empty line, the
/// body. LSP 3.17, "Base Protocol".
namespace proskill::rpc {

/// Bytes that are not a message. The reader continues after them, at the next header.
struct FramingError {
  std::string message;
};

using Frame = std::variant<std::string, FramingError>;

/// Cuts a stream into messages, whatever the sizes of the pieces in which it comes.
class FrameReader {
public:
  /// A body longer than `limit` bytes is skipped as it comes, and never held.
  explicit FrameReader(std::size_t limit = std::size_t{256} << 20) : limit(limit) {}

  void feed(std::string_view bytes);
  /// The body of the next message, or an error of the stream; nothing until more bytes come.
  [[nodiscard]] std::optional<Frame> next();

private:
  std::optional<Frame> readHeader();
  std::optional<Frame> readBody();
  void skip();
  Frame resynchronise(std::string message);

  std::size_t limit;
  std::string buffer;
  std::size_t position = 0;              ///< end of the processed part of the buffer
  bool lost = false;                     ///< the next bytes need not be a header
  std::optional<std::size_t> bodyLength; ///< known: the header has been read
  std::size_t toSkip = 0;                ///< of a body that is too long
};

/// The header of a body of so many bytes.
[[nodiscard]] std::string header(std::size_t length);
/// A message as it is sent.
[[nodiscard]] std::string frame(std::string_view body);

} // namespace proskill::rpc
