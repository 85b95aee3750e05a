#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <type_traits>

namespace proskill::runtime {

/// A queue of byte strings from one thread to another, without locks and with a fixed capacity.
/// Each entry has a head and is contiguous. While the reader keeps up, only the beginning of the
/// memory is used.
template <class Head> class ByteQueue {
  static_assert(std::is_trivially_copyable_v<Head>);

public:
  explicit ByteQueue(std::size_t capacity)
      : size(roundedUp(capacity)), memory(std::make_unique_for_overwrite<char[]>(size)) {}

  /// For the thread that adds. \return false if there is no room
  /// \pre an entry takes less than half of the capacity
  bool push(const Head& head, std::string_view bytes) {
    const auto needed = roundedUp(sizeof(Entry) + bytes.size());
    auto at = tail.load(std::memory_order_relaxed);
    const auto first = begin.load(std::memory_order_acquire);
    const auto toEnd = size - at % size;
    const bool restarts = first == at && at % size > kUsualPart && toEnd + needed <= size;
    const bool wraps = restarts || toEnd < needed;
    if (at - first + needed + (wraps ? toEnd : 0) > size) return false;
    if (wraps) {
      write(at, Entry{.isEnd = true, .size = 0, .head = head}, {});
      at += toEnd;
    }
    write(at, Entry{.isEnd = false, .size = bytes.size(), .head = head}, bytes);
    tail.store(at + needed, std::memory_order_release);
    return true;
  }

  /// For the thread that removes: `use(head, bytes)` reads the first entry.
  /// \return false if the queue is empty
  template <class Use> bool pop(Use&& use) {
    auto at = begin.load(std::memory_order_relaxed);
    if (at == tail.load(std::memory_order_acquire)) return false;
    auto entry = read(at);
    if (entry.isEnd) entry = read(at += size - at % size);
    use(entry.head, std::string_view(memory.get() + at % size + sizeof(Entry), entry.size));
    begin.store(at + roundedUp(sizeof(Entry) + entry.size), std::memory_order_release);
    return true;
  }

  /// Number of bytes in it; at once outdated if the other thread is at work.
  [[nodiscard]] std::size_t used() const {
    const auto first = begin.load(std::memory_order_acquire);
    return tail.load(std::memory_order_acquire) - first;
  }

private:
  struct Entry {
    bool isEnd = false; ///< the next entry is at the beginning of the memory
    std::size_t size = 0;
    Head head;
  };
  static constexpr std::size_t kUsualPart = std::size_t{1} << 20;
  /// So that an entry that says where the memory ends always fits.
  static constexpr std::size_t kUnit = (sizeof(Entry) + 15) / 16 * 16;

  static constexpr std::size_t roundedUp(std::size_t bytes) {
    return (bytes + kUnit - 1) / kUnit * kUnit;
  }
  void write(std::uint64_t at, const Entry& entry, std::string_view bytes) {
    auto* to = memory.get() + at % size;
    std::memcpy(to, &entry, sizeof entry);
    if (!bytes.empty()) std::memcpy(to + sizeof entry, bytes.data(), bytes.size());
  }
  [[nodiscard]] Entry read(std::uint64_t at) const {
    Entry entry;
    std::memcpy(&entry, memory.get() + at % size, sizeof entry);
    return entry;
  }

  std::size_t size;
  std::unique_ptr<char[]> memory;
  std::atomic<std::uint64_t> begin{0}; ///< places since the start; modulo the size they are indices
  std::atomic<std::uint64_t> tail{0};
};

} // namespace proskill::runtime
