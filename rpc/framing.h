#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

/// Framing of messages in a stream of bytes: a header with `Content-Length`, an empty line, the
/// body. LSP 3.17, "Base Protocol".
namespace proskill::rpc {

/// Bytes that are not a message. Reading continues at the next header after them.
struct FramingError {
  std::string message;
};

using Frame = std::variant<std::string, FramingError>;

/// Splits a stream into messages; pieces of the stream may have any size.
class FrameReader {
public:
  /// \param limit bodies longer than this many bytes are skipped without buffering them
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
  std::size_t position = 0;              ///< end of the processed bytes of the buffer
  bool lost = false;                     ///< searching for the next header
  std::optional<std::size_t> bodyLength; ///< set once the header has been read
  std::size_t toSkip = 0;                ///< remaining bytes of a body that is too long
};

/// The header for a body of this length.
[[nodiscard]] std::string header(std::size_t length);
/// A message as it is sent.
[[nodiscard]] std::string frame(std::string_view body);

} // namespace proskill::rpc
