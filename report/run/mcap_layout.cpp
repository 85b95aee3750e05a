#include "report/run/blocks.h"
#include "report/run/mcap.h"
#include "report/run/mcap_records.h"

#include <algorithm>

namespace proskill::report::mcap {

namespace {

constexpr std::uint64_t kFooterSize = kRecordHead + 8 + 8 + 4;
constexpr std::uint64_t kBlock = 4'096;

class LayoutReader {
public:
  explicit LayoutReader(const File& of) : file(of), blocks(of, kBlock) {}

  Layout read() {
    if (readSummary()) return std::move(layout);
    layout = {};
    scan();
    return std::move(layout);
  }

private:
  /// \return false if there is none that names chunks
  bool readSummary() {
    if (file.size < 2 * kMagic.size() + kFooterSize) return false;
    const auto end = file.size - kMagic.size() - kFooterSize;
    const auto bytes = file.read(end, kFooterSize + kMagic.size());
    if (!bytes.ends_with(kMagic)) return false;
    const auto footer = Cursor(bytes).record();
    if (!footer || footer->opcode != Opcode::Footer) return false;
    const auto begin = Cursor(footer->content).number(8);
    if (begin < kMagic.size() || begin >= end) return false;
    const auto summary = file.readAtMost(begin, end - begin);
    Cursor all(summary);
    while (const auto record = all.record()) take(*record);
    return !layout.stretches.empty();
  }

  void take(const Record& record) {
    Cursor in(record.content);
    if (record.opcode == Opcode::Channel) takeChannel(record.content);
    if (record.opcode == Opcode::Metadata) takeMetadata(record.content);
    if (record.opcode == Opcode::ChunkIndex) {
      Stretch stretch{.first = in.number(8), .last = in.number(8)};
      stretch.at = in.number(8);
      stretch.size = in.number(8);
      layout.stretches.push_back(stretch);
    }
    if (record.opcode == Opcode::MetadataIndex) {
      const auto at = in.number(8);
      const auto bytes = file.readAtMost(at, in.number(8));
      const auto found = Cursor(bytes).record();
      if (found && found->opcode == Opcode::Metadata) takeMetadata(found->content);
    }
  }

  void takeChannel(std::string_view content) {
    const auto [id, topic] = channelIn(content);
    layout.channels.emplace(topic, id);
  }

  void takeMetadata(std::string_view content) {
    const auto [name, value] = metadataIn(content);
    layout.metadata.emplace(name, value);
  }

  /// Goes from record to record. Messages of chunks are skipped.
  void scan() {
    for (std::uint64_t at = kMagic.size(); at + kRecordHead <= file.size;) {
      Cursor head(blocks.at(at, kRecordHead));
      const auto kind = static_cast<Opcode>(head.number(1));
      const auto length = head.number(8);
      const auto rest = file.size - at - kRecordHead;
      if (kind == Opcode::DataEnd || (length > rest && kind != Opcode::Chunk)) return;
      const auto size = kRecordHead + std::min(length, rest);
      see(kind, at, size);
      at += size;
    }
  }

  void see(Opcode kind, std::uint64_t at, std::uint64_t size) {
    const auto inside = at + kRecordHead;
    if (kind == Opcode::Channel || kind == Opcode::Metadata) {
      const auto bytes = file.readAtMost(inside, size - kRecordHead);
      return take({kind, bytes});
    }
    const bool isLoose = std::exchange(wasLoose, kind == Opcode::Message);
    if (kind == Opcode::Chunk) {
      Cursor in(blocks.at(inside, 16));
      layout.stretches.push_back({at, size, in.number(8), in.number(8)});
    }
    if (kind == Opcode::Message) seeMessage(at, size, isLoose);
  }

  void seeMessage(std::uint64_t at, std::uint64_t size, bool goesOn) {
    Cursor in(blocks.at(at + kRecordHead, 14));
    in.number(2 + 4); // channel and sequence
    const auto time = in.number(8);
    if (!goesOn) layout.stretches.push_back({at, 0, time, time});
    auto& stretch = layout.stretches.back();
    stretch.size = at + size - stretch.at;
    stretch.last = std::max(stretch.last, time);
  }

  const File& file;
  Blocks blocks;
  Layout layout;
  bool wasLoose = false; ///< whether the last record was a message in no chunk
};

} // namespace

Layout layoutOf(const File& file) { return LayoutReader(file).read(); }

} // namespace proskill::report::mcap
