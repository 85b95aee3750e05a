#include "report/run/mcap.h"

#include "report/run/mcap_records.h"

#include <algorithm>
#include <optional>

namespace proskill::report::mcap {

namespace {

class Reader {
public:
  explicit Reader(std::string_view of, std::optional<std::uint64_t> known = {})
      : topic(of), channel(known) {}

  /// \return an error; empty on success
  std::string read(std::string_view bytes, bool isInChunk = false) {
    Cursor all(bytes);
    while (const auto record = all.record())
      if (auto wrong = take(*record, isInChunk); !wrong.empty()) return wrong;
    return "";
  }

  Content content;

private:
  std::string take(const Record& record, bool isInChunk) {
    if (record.opcode == Opcode::Channel) takeChannel(record.content);
    if (record.opcode == Opcode::Message) takeMessage(record.content);
    if (record.opcode == Opcode::Metadata) takeMetadata(record.content);
    if (record.opcode != Opcode::Chunk) return "";
    return isInChunk ? "a chunk is within another" : takeChunk(record.content);
  }

  void takeChannel(std::string_view content) {
    const auto [id, name] = channelIn(content);
    if (name == topic) channel = id;
  }

  void takeMessage(std::string_view bytes) {
    Cursor in(bytes);
    if (in.number(2) != channel) return;
    in.take(4 + 8 + 8); // sequence, and both times
    content.messages.push_back(in.take(in.size()));
  }

  void takeMetadata(std::string_view bytes) {
    const auto [name, value] = metadataIn(bytes);
    content.metadata.emplace(name, value);
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

  std::string_view topic;
  std::optional<std::uint64_t> channel;
};

} // namespace

bool isMcap(std::string_view bytes) { return bytes.starts_with(kMagic); }

std::expected<Content, std::string> read(std::string_view bytes, std::string_view topic) {
  if (!isMcap(bytes)) return std::unexpected("it is not an MCAP file");
  Reader reader(topic);
  if (auto wrong = reader.read(bytes.substr(kMagic.size())); !wrong.empty())
    return std::unexpected(std::move(wrong));
  return std::move(reader.content);
}

std::expected<std::vector<std::string_view>, std::string> messagesIn(std::string_view bytes,
                                                                     std::uint16_t channel) {
  Reader reader("", channel);
  if (auto wrong = reader.read(bytes); !wrong.empty()) return std::unexpected(std::move(wrong));
  return std::move(reader.content.messages);
}

} // namespace proskill::report::mcap
