#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Writes and reads records of MCAP files, version 0 (https://mcap.dev/spec), without compression.
/// Each function that writes appends to a string.
namespace proskill::report::mcap {

/// Start of a file.
void addHead(std::string& to);
/// Schema record in JSON Schema. \param id not 0
void addSchema(std::string& to, std::uint16_t id, std::string_view name, std::string_view schema);
/// Channel record for JSON messages.
void addChannel(std::string& to, std::uint16_t id, std::uint16_t schema, std::string_view topic);
/// \param time in nanoseconds
void addMessage(std::string& to, std::uint16_t channel, std::uint32_t sequence, std::uint64_t time,
                std::string_view json);
/// Metadata record with one entry.
void addMetadata(std::string& to, std::string_view name, std::string_view key,
                 std::string_view value);
/// Size of what precedes the messages of a chunk: the heads of its record and of their block.
inline constexpr std::size_t kChunkHead = 49;
/// Room for the head of a chunk, as a record that readers skip. Until the head is written there,
/// the messages that follow are records of the file.
/// \param at offset of the end of `to`; the head will not lie across a page of memory
void addRoomForChunk(std::string& to, std::uint64_t at);

/// A chunk, as the index knows it.
struct Chunk {
  std::uint64_t at = 0;    ///< offset of its record
  std::uint64_t size = 0;  ///< of its messages' records
  std::uint64_t first = 0; ///< earliest and latest time of a message
  std::uint64_t last = 0;
  std::map<std::uint16_t, std::uint64_t> indexes; ///< by channel: offset of the message index
  std::uint64_t indexSize = 0;                    ///< of all message indexes
};
/// What replaces the room for the head of a chunk.
[[nodiscard]] std::string chunkHead(const Chunk& chunk);
/// Time of each message of a channel, and its offset in the chunk.
using MessageIndex = std::vector<std::pair<std::uint64_t, std::uint64_t>>;
void addMessageIndex(std::string& to, std::uint16_t channel, const MessageIndex& index);

/// What a summary says of a file.
struct Summary {
  std::string channels; ///< the records of schemas and channels
  std::vector<Chunk> chunks;
  std::map<std::uint16_t, std::uint64_t> counts; ///< of messages, by channel
  std::string metadataName;                      ///< the one metadata record
  std::uint64_t metadataAt = 0;
  std::uint64_t metadataSize = 0;
};
/// End of a file with a summary. \param at its offset
[[nodiscard]] std::string tail(const Summary& summary, std::uint64_t at);
/// End of a file without summary.
[[nodiscard]] std::string tail();

/// Whether a file is an MCAP file.
[[nodiscard]] bool isMcap(std::string_view bytes);

/// A file of which parts are read. Bytes after its end are not returned.
struct File {
  std::uint64_t size = 0;
  std::function<std::string(std::uint64_t at, std::uint64_t size)> read;

  [[nodiscard]] bool isMcap() const { return mcap::isMcap(read(0, 8)); }
  /// The bytes, but not so many that a damaged length fills the memory.
  [[nodiscard]] std::string readAtMost(std::uint64_t at, std::uint64_t bytes) const {
    constexpr std::uint64_t kMost = std::uint64_t{256} << 20;
    return read(at, bytes < kMost ? bytes : kMost);
  }
};

/// A chunk, or messages that are in none.
struct Stretch {
  std::uint64_t at = 0; ///< offset of its records
  std::uint64_t size = 0;
  std::uint64_t first = 0; ///< earliest and latest time of a message
  std::uint64_t last = 0;
};

/// Where the messages of a file are.
struct Layout {
  std::map<std::string, std::string> metadata;   ///< by the name of its record: the first value
  std::map<std::string, std::uint16_t> channels; ///< by topic
  std::vector<Stretch> stretches;                ///< in the order of the file
};
/// Reads the summary of a file, or else the heads of its chunks. \pre it is an MCAP file
[[nodiscard]] Layout layoutOf(const File& file);
/// Reads the messages of a channel one by one, however large the file is. A file that was cut off
/// is read up to its last complete record. \pre it is an MCAP file \param use gets each message, in
/// the order of the file, and returns whether more is wanted \return an error message, or nothing
[[nodiscard]] std::optional<std::string>
readMessages(const File& file, std::string_view topic,
             const std::function<bool(std::string_view message)>& use);
/// Value of the metadata record with this name, wherever it is in the file; empty if there is none.
[[nodiscard]] std::string metadataOf(const File& file, std::string_view name);
/// The messages of a channel in the bytes of stretches. The error is a message.
[[nodiscard]] std::expected<std::vector<std::string_view>, std::string>
messagesIn(std::string_view bytes, std::uint16_t channel);

} // namespace proskill::report::mcap
