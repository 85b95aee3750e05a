#include "verify/ranks/exchange.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace proskill::verify {

std::string bytesOf(const std::function<void(CheckpointWriter&)>& write) {
  std::string bytes;
  const CheckpointStore::Put put = [&](std::string_view piece) {
    bytes += piece;
    return true;
  };
  CheckpointWriter writer(put);
  write(writer);
  writer.flush();
  return bytes;
}

CheckpointReader readerOf(std::string bytes) {
  return CheckpointReader([left = std::move(bytes)]() mutable { return std::exchange(left, {}); });
}

std::string firstOf(const std::vector<std::string>& texts) {
  const auto found = std::ranges::find_if(texts, [](const auto& text) { return !text.empty(); });
  return found == texts.end() ? std::string() : *found;
}

Exchange::Exchange(Ranks& over, OnMessage handler)
    : ranks(over),
      onMessage(std::move(handler)),
      batches(over.count()),
      put([this](std::string_view piece) {
        *current += piece;
        return true;
      }),
      writer(put) {}

void Exchange::send(unsigned to) {
  current = &batches[to];
  writer.number(0);
  writer.flush();
  ++traffic.messages;
  traffic.bytes += current->size();
  ranks.send(to, std::exchange(*current, {}));
  while (ranks.isBusy()) receive();
}

void Exchange::receive() {
  while (auto message = ranks.receive()) {
    CheckpointReader records = readerOf(std::move(message->bytes));
    onMessage(message->from, records);
    assert(!records.hasFailed());
  }
}

void Exchange::finishRound() {
  for (unsigned to = 0; to < batches.size(); ++to)
    if (!isNew(to)) send(to);
  do receive();
  while (!ranks.isRoundOver());
}

std::uint64_t Exchange::bytes() const {
  std::uint64_t all = 0;
  for (const auto& batch : batches) all += batch.capacity();
  return all;
}

} // namespace proskill::verify
