#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

namespace proskill::runtime {

/// A queue of fixed size from one thread to another, without locks. Elements are reused, so strings
/// keep their memory.
template <class T> class BoundedQueue {
public:
  /// \param size the most elements in it
  explicit BoundedQueue(std::size_t size) : slots(size + 1) {}

  /// For the thread that adds: `fill` sets the new element, which has an older value.
  /// \return false if the queue is full
  template <class Fill> bool push(Fill&& fill) {
    const auto at = tail.load(std::memory_order_relaxed);
    const auto next = after(at);
    if (next == head.load(std::memory_order_acquire)) return false;
    fill(slots[at]);
    tail.store(next, std::memory_order_release);
    return true;
  }

  /// For the thread that removes: `use` reads the first element.
  /// \return false if the queue is empty
  template <class Use> bool pop(Use&& use) {
    const auto at = head.load(std::memory_order_relaxed);
    if (at == tail.load(std::memory_order_acquire)) return false;
    use(slots[at]);
    head.store(after(at), std::memory_order_release);
    return true;
  }

  /// Number of elements; at once outdated if another thread is at work.
  [[nodiscard]] std::size_t size() const {
    const auto first = head.load(std::memory_order_acquire);
    return (tail.load(std::memory_order_acquire) + slots.size() - first) % slots.size();
  }

private:
  [[nodiscard]] std::size_t after(std::size_t at) const {
    return at + 1 == slots.size() ? 0 : at + 1;
  }

  std::vector<T> slots; ///< one of them is always free
  std::atomic<std::size_t> head{0};
  std::atomic<std::size_t> tail{0};
};

} // namespace proskill::runtime
