#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace proskill::report::mcap {

/// What an MCAP file begins and ends with.
inline constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
/// The size of what precedes the content of a record: an opcode and a length.
inline constexpr std::size_t kRecordHead = 9;

enum class Opcode : std::uint8_t {
  Header = 1,
  Footer = 2,
  Schema = 3,
  Channel = 4,
  Message = 5,
  Chunk = 6,
  MessageIndex = 7,
  ChunkIndex = 8,
  Statistics = 11,
  Metadata = 12,
  MetadataIndex = 13,
  DataEnd = 15,
  Room = 0x80, ///< of an application: other readers skip it
};

struct Record {
  Opcode opcode{};
  std::string_view content;
};

/// Takes numbers and texts from the beginning of bytes. Where bytes are missing, what is taken is
/// empty, and the rest too.
class Cursor {
public:
  explicit Cursor(std::string_view from) : rest(from) {}

  [[nodiscard]] std::size_t size() const { return rest.size(); }

  std::uint64_t number(std::size_t size) {
    const auto bytes = take(size);
    std::uint64_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;)
      value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
  }
  std::string_view text() { return take(number(4)); }
  std::string_view bytes() { return take(number(8)); }

  /// The next record, if it is complete.
  std::optional<Record> record() {
    if (rest.size() < kRecordHead) return std::nullopt;
    Cursor head(rest);
    Record next;
    next.opcode = static_cast<Opcode>(head.number(1));
    const auto length = head.number(8);
    if (length > head.rest.size()) {
      // The messages of a chunk that was cut off are complete but for the last.
      if (next.opcode != Opcode::Chunk) return std::nullopt;
      next.content = std::exchange(rest, {}).substr(kRecordHead);
      return next;
    }
    next.content = head.take(length);
    rest = head.rest;
    return next;
  }

  std::string_view take(std::uint64_t size) {
    if (size > rest.size()) {
      rest = {};
      return {};
    }
    const auto taken = rest.substr(0, size);
    rest.remove_prefix(size);
    return taken;
  }

private:
  std::string_view rest;
};

struct ChannelRecord {
  std::uint16_t id = 0;
  std::string_view topic;
};
[[nodiscard]] inline ChannelRecord channelIn(std::string_view content) {
  Cursor in(content);
  const auto id = static_cast<std::uint16_t>(in.number(2));
  in.number(2); // schema
  return {id, in.text()};
}

/// The content of a message, if it is of this channel.
[[nodiscard]] inline std::optional<std::string_view> messageIn(std::string_view content,
                                                               std::uint16_t channel) {
  Cursor in(content);
  if (in.number(2) != channel) return std::nullopt;
  in.take(4 + 8 + 8); // sequence, and both times
  return in.take(in.size());
}

/// Metadata with one entry, whose key does not matter.
struct MetadataRecord {
  std::string_view name;
  std::string_view value;
};
[[nodiscard]] inline MetadataRecord metadataIn(std::string_view content) {
  Cursor in(content);
  const auto name = in.text();
  in.number(4); // length of the map
  in.text();    // key
  return {name, in.text()};
}

} // namespace proskill::report::mcap
