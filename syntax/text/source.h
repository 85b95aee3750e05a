#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::syntax {

/// A position in a text, in bytes from its start.
using Offset = std::uint32_t;

/// A half-open range of a text, in bytes.
struct Range {
  Offset begin = 0;
  Offset end = 0;

  [[nodiscard]] bool empty() const { return begin == end; }
  [[nodiscard]] Offset length() const { return end - begin; }
  /// The range `by` bytes further towards the end of the text; `by` may wrap around.
  [[nodiscard]] Range moved(Offset by) const { return {begin + by, end + by}; }
  [[nodiscard]] bool contains(Offset at) const { return begin <= at && at < end; }
  /// Whether the ranges overlap or are adjacent.
  [[nodiscard]] bool touches(Range other) const { return begin <= other.end && other.begin <= end; }
  friend bool operator==(const Range&, const Range&) = default;
};

/// A line and a column in bytes, both counted from 0.
struct Position {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  friend auto operator<=>(const Position&, const Position&) = default;
};

/// The offsets at which the lines of a text begin. `\n` and `\r\n` end a line.
class LineIndex {
public:
  explicit LineIndex(std::string_view text);
  /// The line index after `range` is replaced by `put`.
  [[nodiscard]] LineIndex edited(Range range, std::string_view put) const;

  [[nodiscard]] Position position(Offset at) const;
  /// The same, faster if the offset is in a line near `line`. Sets `line` to the offset's line.
  [[nodiscard]] Position position(Offset at, std::uint32_t& line) const;
  /// A position after the end of its line, or of the text, gives that end.
  [[nodiscard]] Offset offset(Position position) const;
  [[nodiscard]] std::uint32_t lineCount() const;
  /// The line without its end.
  [[nodiscard]] Range line(std::uint32_t number, std::string_view text) const;

private:
  LineIndex() = default;
  /// Adds the lines that begin in a text at offset `at`.
  void add(std::string_view text, Offset at);

  std::vector<Offset> starts{0};
  Offset size = 0;
};

/// A digest of 128 bits as 32 hexadecimal digits. Different texts have different digests for all
/// practical purposes, but the digest does not protect against deliberate collisions.
[[nodiscard]] std::string digestOf(std::string_view text);

} // namespace proskill::syntax
