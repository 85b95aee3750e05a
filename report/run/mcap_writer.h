#pragma once

#include "report/run/mcap.h"
#include "report/run/run_report.h"

namespace proskill::report::mcap {

/// Writes an MCAP file with chunks and an index, of which everything that was handed over can be
/// read at any time: a message is a record of the file until its chunk is full, and then becomes a
/// part of the chunk by the head that is written before it. No message is written twice.
class Writer {
public:
  /// \param size at which a chunk is full, in bytes
  Writer(RecordingSink to, std::size_t size);

  /// Before all channels and messages, once.
  void addMetadata(std::string_view name, std::string_view key, std::string_view value);
  /// Before all messages. \param id not 0
  void addChannel(std::uint16_t id, std::string_view name, std::string_view schema,
                  std::string_view topic);
  /// Begins a chunk, and ends the one before.
  void beginChunk();
  /// Whether the next chunk should begin.
  [[nodiscard]] bool isFull() const { return isOpen && at() - messagesAt >= chunkSize; }
  /// \pre a chunk has begun
  void addMessage(std::uint16_t channel, std::uint64_t time, std::string_view json);
  /// Hands over what was added.
  void flush();
  /// Ends the file. Nothing is added to it any more.
  void finish();

private:
  [[nodiscard]] std::uint64_t at() const { return written + bytes.size(); }
  void endChunk();

  RecordingSink sink;
  std::size_t chunkSize;
  std::string_view end; ///< of the file, until it is finished
  std::string bytes;
  std::uint64_t written = 0;
  std::uint32_t sequence = 0;
  bool isOpen = false;
  std::uint64_t messagesAt = 0; ///< of the open chunk
  Chunk chunk;
  std::map<std::uint16_t, MessageIndex> indexes;
  Summary summary;
};

} // namespace proskill::report::mcap
