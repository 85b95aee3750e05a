#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

/// How messages stand in a stream of bytes: a header with `Content-Length`, an empty line, the
/// body. LSP 3.17, "Base Protocol".
namespace proskill::rpc {

/// Bytes that are no message. The reader goes on behind them, at the next header that it can find.
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
  /// The next message's body or what is wrong with the stream; nothing until more bytes come.
  [[nodiscard]] std::optional<Frame> next();

private:
  std::optional<Frame> readHeader();
  std::optional<Frame> readBody();
  void skip();
  Frame resynchronise(std::string message);

  std::size_t limit;
  std::string buffer;
  std::size_t position = 0;              ///< what of the buffer is done with
  bool lost = false;                     ///< what stands there need not be a header
  std::optional<std::size_t> bodyLength; ///< known: the header has been read
  std::size_t toSkip = 0;                ///< of a body that is too long
};

/// What stands before a body of so many bytes.
[[nodiscard]] std::string header(std::size_t length);
/// A message as it goes out.
[[nodiscard]] std::string frame(std::string_view body);

} // namespace proskill::rpc
