#pragma once

#include "verify/checkpoint/reader.h"
#include "verify/checkpoint/writer.h"
#include "verify/ranks.h"

#include <functional>
#include <string>
#include <vector>

namespace proskill::verify {

/// What a function writes, as bytes.
[[nodiscard]] std::string bytesOf(const std::function<void(CheckpointWriter&)>& write);
[[nodiscard]] CheckpointReader readerOf(std::string bytes);

/// The first of these texts that is not empty, if any.
[[nodiscard]] std::string firstOf(const std::vector<std::string>& texts);

/// What was sent to other ranks.
struct Traffic {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
};

/// Collects records for other ranks into messages. Latency and the cost of a call matter once for a
/// message, not for each record.
class Exchange {
public:
  /// Reads a message: each record follows a flag that is set, and an unset one ends it.
  using OnMessage = std::function<void(unsigned from, CheckpointReader& records)>;

  /// \pre the argument outlives this
  Exchange(Ranks& over, OnMessage handler);
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  /// Whether the next record for a rank is the first of a message.
  [[nodiscard]] bool isNew(unsigned to) const { return batches[to].empty(); }
  /// Adds a record for another rank.
  template <class Write> void add(unsigned to, Write write) {
    current = &batches[to];
    writer.number(1);
    write(writer);
    writer.flush();
    if (current->size() >= kBatch) send(to);
  }
  /// Handles all messages that have arrived.
  void receive();
  /// Sends what is left and receives until no rank has anything more to send.
  void finishRound();
  [[nodiscard]] const Traffic& sent() const { return traffic; }
  [[nodiscard]] std::uint64_t bytes() const;

private:
  static constexpr std::size_t kBatch = std::size_t{16} << 10;

  void send(unsigned to);

  Ranks& ranks;
  OnMessage onMessage;
  std::vector<std::string> batches; ///< by rank
  std::string* current = nullptr;   ///< to which the writer adds
  CheckpointStore::Put put;
  CheckpointWriter writer;
  Traffic traffic;
};

} // namespace proskill::verify
