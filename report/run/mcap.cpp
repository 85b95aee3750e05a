#include "report/run/mcap.h"

#include "report/run/mcap_records.h"

#include <algorithm>
#include <array>
#include <bit>

namespace proskill::report::mcap {

namespace {

constexpr std::uint64_t kPage = 4096;

/// Little-endian.
template <class Number> void addNumber(std::string& to, Number number) {
  auto bytes = std::bit_cast<std::array<char, sizeof number>>(number);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(bytes);
  to.append(bytes.data(), bytes.size());
}

void addText(std::string& to, std::string_view text) {
  addNumber(to, static_cast<std::uint32_t>(text.size()));
  to += text;
}

void begin(std::string& to, Opcode opcode, std::uint64_t length) {
  to += static_cast<char>(opcode);
  addNumber(to, length);
}

void addRecord(std::string& to, Opcode opcode, std::string_view content) {
  begin(to, opcode, content.size());
  to += content;
}

} // namespace

void addHead(std::string& to) {
  to += kMagic;
  std::string content;
  addText(content, "");
  addText(content, "proskill");
  addRecord(to, Opcode::Header, content);
}

void addSchema(std::string& to, std::uint16_t id, std::string_view name, std::string_view schema) {
  std::string content;
  addNumber(content, id);
  addText(content, name);
  addText(content, "jsonschema");
  addText(content, schema);
  addRecord(to, Opcode::Schema, content);
}

void addChannel(std::string& to, std::uint16_t id, std::uint16_t schema, std::string_view topic) {
  std::string content;
  addNumber(content, id);
  addNumber(content, schema);
  addText(content, topic);
  addText(content, "json");
  addNumber(content, std::uint32_t{0}); // no metadata
  addRecord(to, Opcode::Channel, content);
}

void addMessage(std::string& to, std::uint16_t channel, std::uint32_t sequence, std::uint64_t time,
                std::string_view json) {
  begin(to, Opcode::Message, 2 + 4 + 8 + 8 + json.size());
  addNumber(to, channel);
  addNumber(to, sequence);
  addNumber(to, time); // when it was recorded, and when it was sent
  addNumber(to, time);
  to += json;
}

void addMetadata(std::string& to, std::string_view name, std::string_view key,
                 std::string_view value) {
  std::string content;
  addText(content, name);
  addNumber(content, static_cast<std::uint32_t>(4 + key.size() + 4 + value.size()));
  addText(content, key);
  addText(content, value);
  addRecord(to, Opcode::Metadata, content);
}

void addRoomForChunk(std::string& to, std::uint64_t at) {
  const auto rest = kPage - at % kPage;
  if (rest < kChunkHead)
    addRecord(to, Opcode::Room, std::string(std::max(rest, kRecordHead) - kRecordHead, '\0'));
  addRecord(to, Opcode::Room, std::string(kChunkHead - kRecordHead, '\0'));
}

std::string chunkHead(const Chunk& chunk) {
  std::string made;
  begin(made, Opcode::Chunk, kChunkHead - kRecordHead + chunk.size);
  addNumber(made, chunk.first);
  addNumber(made, chunk.last);
  addNumber(made, chunk.size);
  addNumber(made, std::uint32_t{0}); // no checksum
  addText(made, "");                 // no compression
  addNumber(made, chunk.size);
  return made;
}

void addMessageIndex(std::string& to, std::uint16_t channel, const MessageIndex& index) {
  const auto size = static_cast<std::uint32_t>(16 * index.size());
  begin(to, Opcode::MessageIndex, 2 + 4 + size);
  addNumber(to, channel);
  addNumber(to, size);
  for (const auto& [time, offset] : index) {
    addNumber(to, time);
    addNumber(to, offset);
  }
}

namespace {

void addChunkIndex(std::string& to, const Chunk& chunk) {
  std::string content;
  addNumber(content, chunk.first);
  addNumber(content, chunk.last);
  addNumber(content, chunk.at);
  addNumber(content, kChunkHead + chunk.size);
  addNumber(content, static_cast<std::uint32_t>(10 * chunk.indexes.size()));
  for (const auto& [channel, offset] : chunk.indexes) {
    addNumber(content, channel);
    addNumber(content, offset);
  }
  addNumber(content, chunk.indexSize);
  addText(content, "");
  addNumber(content, chunk.size);
  addNumber(content, chunk.size);
  addRecord(to, Opcode::ChunkIndex, content);
}

void addStatistics(std::string& to, const Summary& summary) {
  std::uint64_t messages = 0;
  for (const auto& [channel, count] : summary.counts) messages += count;
  const auto channels = static_cast<std::uint32_t>(summary.counts.size());
  std::string content;
  addNumber(content, messages);
  addNumber(content, static_cast<std::uint16_t>(channels)); // each has a schema
  addNumber(content, channels);
  addNumber(content, std::uint32_t{0}); // attachments
  addNumber(content, std::uint32_t{1}); // metadata
  addNumber(content, static_cast<std::uint32_t>(summary.chunks.size()));
  addNumber(content, summary.chunks.empty() ? 0 : summary.chunks.front().first);
  addNumber(content, summary.chunks.empty() ? 0 : summary.chunks.back().last);
  addNumber(content, 10 * channels);
  for (const auto& [channel, count] : summary.counts) {
    addNumber(content, channel);
    addNumber(content, count);
  }
  addRecord(to, Opcode::Statistics, content);
}

void addMetadataIndex(std::string& to, const Summary& summary) {
  std::string content;
  addNumber(content, summary.metadataAt);
  addNumber(content, summary.metadataSize);
  addText(content, summary.metadataName);
  addRecord(to, Opcode::MetadataIndex, content);
}

void addFooter(std::string& to, std::uint64_t summary) {
  std::string content;
  addNumber(content, summary);
  content += std::string(8 + 4, '\0'); // no offsets in the summary, no checksum
  addRecord(to, Opcode::Footer, content);
  to += kMagic;
}

} // namespace

std::string tail(const Summary& summary, std::uint64_t at) {
  std::string made;
  addRecord(made, Opcode::DataEnd, std::string(4, '\0')); // no checksum
  const auto begin = at + made.size();
  made += summary.channels;
  addStatistics(made, summary);
  for (const auto& chunk : summary.chunks) addChunkIndex(made, chunk);
  addMetadataIndex(made, summary);
  addFooter(made, begin);
  return made;
}

std::string tail() {
  std::string made;
  addRecord(made, Opcode::DataEnd, std::string(4, '\0'));
  addFooter(made, 0);
  return made;
}

} // namespace proskill::report::mcap
