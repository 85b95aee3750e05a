#include "report/run/blocks.h"
#include "report/run/mcap.h"
#include "report/run/mcap_records.h"

#include <algorithm>
#include <optional>

namespace proskill::report::mcap {

namespace {

constexpr std::uint64_t kReadAhead = std::uint64_t{1} << 20;

/// The records of a file one after the other. Those of a chunk follow its head.
class RecordStream {
public:
  explicit RecordStream(const File& of) : file(of), blocks(of, kReadAhead) {}

  /// The next channel, metadata or message, if it is complete. Valid until the next call.
  std::optional<Record> next() {
    while (error.empty() && place + kRecordHead <= file.size) {
      Cursor head(blocks.at(place, kRecordHead));
      const auto opcode = static_cast<Opcode>(head.number(1));
      const auto length = head.number(8);
      place += kRecordHead;
      if (opcode == Opcode::DataEnd) return std::nullopt;
      if (opcode == Opcode::Chunk)
        enterChunk(length);
      else if (const auto content = contentOf(opcode, length))
        return Record{opcode, *content};
    }
    return std::nullopt;
  }

  std::string error;

private:
  std::optional<std::string_view> contentOf(Opcode opcode, std::uint64_t length) {
    const auto end = place < chunkEnd ? chunkEnd : file.size;
    const auto begin = place;
    const bool isCutOff = length > end - std::min(begin, end);
    place = isCutOff ? end : begin + length;
    const bool isRead =
        opcode == Opcode::Channel || opcode == Opcode::Message || opcode == Opcode::Metadata;
    if (isCutOff || !isRead) return std::nullopt;
    const auto content = blocks.at(begin, length);
    if (content.size() == length) return content;
    error = "it has a message of more than 256 MiB";
    return std::nullopt;
  }

  /// The messages of a chunk that was cut off are complete but for the last.
  void enterChunk(std::uint64_t length) {
    constexpr std::uint64_t kBefore = 8 + 8 + 8 + 4; // times, size, checksum
    if (place < chunkEnd) {
      error = "a chunk is within another";
      return;
    }
    chunkEnd = place + std::min(length, file.size - place);
    Cursor in(blocks.at(place + kBefore, kChunkHead - kRecordHead - kBefore));
    const auto size = in.number(4);
    if (size > 0) {
      const auto name = blocks.at(place + kBefore + 4, std::min<std::uint64_t>(size, kMostName));
      error = "its chunks are compressed by " + std::string(name) +
              ": write them without compression first";
      return;
    }
    place = std::min(place + kChunkHead - kRecordHead, chunkEnd);
  }

  static constexpr std::uint64_t kMostName = 32;

  const File& file;
  Blocks blocks;
  std::uint64_t place = kMagic.size();
  std::uint64_t chunkEnd = 0; ///< of the last chunk
};

/// The messages in bytes of a file.
class Reader {
public:
  explicit Reader(std::uint16_t of) : channel(of) {}

  /// \return an error; empty on success
  std::string read(std::string_view bytes, bool isInChunk = false) {
    Cursor all(bytes);
    while (const auto record = all.record())
      if (auto wrong = take(*record, isInChunk); !wrong.empty()) return wrong;
    return "";
  }

  std::vector<std::string_view> messages;

private:
  std::string take(const Record& record, bool isInChunk) {
    if (record.opcode == Opcode::Message)
      if (const auto message = messageIn(record.content, channel)) messages.push_back(*message);
    if (record.opcode != Opcode::Chunk) return "";
    return isInChunk ? "a chunk is within another" : takeChunk(record.content);
  }

  std::string takeChunk(std::string_view bytes) {
    Cursor in(bytes);
    in.take(8 + 8 + 8 + 4); // times, size, checksum
    const auto compression = in.text();
    if (!compression.empty())
      return "its chunks are compressed by " + std::string(compression) +
             ": write them without compression first";
    const auto size = in.number(8);
    return read(in.take(std::min<std::uint64_t>(size, in.size())), true);
  }

  std::uint16_t channel;
};

} // namespace

bool isMcap(std::string_view bytes) { return bytes.starts_with(kMagic); }

std::optional<std::string> readMessages(const File& file, std::string_view topic,
                                        const std::function<bool(std::string_view)>& use) {
  std::optional<std::uint16_t> channel;
  RecordStream records(file);
  while (const auto record = records.next()) {
    if (record->opcode == Opcode::Channel)
      if (const auto [id, name] = channelIn(record->content); name == topic) channel = id;
    if (record->opcode != Opcode::Message || !channel) continue;
    const auto message = messageIn(record->content, *channel);
    if (message && !use(*message)) return std::nullopt;
  }
  if (records.error.empty()) return std::nullopt;
  return std::move(records.error);
}

std::string metadataOf(const File& file, std::string_view name) {
  const auto known = layoutOf(file).metadata;
  if (const auto found = known.find(std::string(name)); found != known.end()) return found->second;
  RecordStream records(file);
  while (const auto record = records.next())
    if (record->opcode == Opcode::Metadata)
      if (const auto [other, value] = metadataIn(record->content); other == name)
        return std::string(value);
  return "";
}

std::expected<std::vector<std::string_view>, std::string> messagesIn(std::string_view bytes,
                                                                     std::uint16_t channel) {
  Reader reader(channel);
  if (auto wrong = reader.read(bytes); !wrong.empty()) return std::unexpected(std::move(wrong));
  return std::move(reader.messages);
}

} // namespace proskill::report::mcap
