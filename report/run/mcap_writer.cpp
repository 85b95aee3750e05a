#include "report/run/mcap_writer.h"

#include <algorithm>

namespace proskill::report::mcap {

namespace {

/// Whoever writes the file may need it after the writer is gone.
std::string_view endWithoutSummary() {
  static const std::string made = tail();
  return made;
}

} // namespace

Writer::Writer(RecordingSink to, std::size_t size)
    : sink(std::move(to)), chunkSize(size), end(endWithoutSummary()) {
  addHead(bytes);
}

void Writer::addMetadata(std::string_view name, std::string_view key, std::string_view value) {
  summary.metadataAt = at();
  mcap::addMetadata(bytes, name, key, value);
  summary.metadataSize = at() - summary.metadataAt;
  summary.metadataName = name;
}

void Writer::addChannel(std::uint16_t id, std::string_view name, std::string_view schema,
                        std::string_view topic) {
  std::string records;
  addSchema(records, id, name, schema);
  mcap::addChannel(records, id, id, topic);
  bytes += records;
  summary.channels += records;
  summary.counts[id] = 0;
  // An index that grows to a new size allocates memory.
  constexpr std::size_t kUsualSize = 64;
  indexes[id].reserve(chunkSize / kUsualSize);
}

void Writer::beginChunk() {
  if (isOpen) endChunk();
  addRoomForChunk(bytes, at());
  isOpen = true;
  messagesAt = at();
  chunk = {.at = messagesAt - kChunkHead};
}

void Writer::addMessage(std::uint16_t channel, std::uint64_t time, std::string_view json) {
  auto& index = indexes[channel];
  chunk.first = at() == messagesAt ? time : std::min(chunk.first, time);
  chunk.last = std::max(chunk.last, time);
  index.emplace_back(time, at() - messagesAt);
  ++summary.counts[channel];
  mcap::addMessage(bytes, channel, sequence++, time, json);
}

void Writer::flush() {
  sink.append(bytes, end);
  written += bytes.size();
  bytes.clear();
}

void Writer::endChunk() {
  flush(); // the head comes after the messages
  isOpen = false;
  chunk.size = at() - messagesAt;
  if (chunk.size == 0) return;
  sink.replace(chunk.at, chunkHead(chunk));
  const auto indexesAt = at();
  for (auto& [channel, index] : indexes) {
    if (index.empty()) continue;
    chunk.indexes[channel] = at();
    addMessageIndex(bytes, channel, index);
    index.clear();
  }
  chunk.indexSize = at() - indexesAt;
  summary.chunks.push_back(chunk);
}

void Writer::finish() {
  if (isOpen) endChunk();
  bytes += tail(summary, at());
  end = {};
  flush();
}

} // namespace proskill::report::mcap
