#pragma once

#include <cstddef>
#include <memory_resource>
#include <type_traits>
#include <utility>
#include <vector>

/// Forms that are parsed together are allocated contiguously in an arena, which is freed as a
/// whole. Copying them takes half as long, and destroying them almost no time.
namespace proskill::syntax {

/// While a scope exists, lists made by its thread are allocated from its memory resource. The
/// resource must outlive the lists.
class ArenaScope {
public:
  explicit ArenaScope(std::pmr::memory_resource& arena) : before(std::exchange(inUse(), &arena)) {}
  ~ArenaScope() { inUse() = before; }
  ArenaScope(const ArenaScope&) = delete;
  ArenaScope& operator=(const ArenaScope&) = delete;

  /// The resource of the innermost scope; outside of all scopes, the heap.
  [[nodiscard]] static std::pmr::memory_resource* current() {
    auto* const arena = inUse();
    return arena ? arena : std::pmr::new_delete_resource();
  }

private:
  static std::pmr::memory_resource*& inUse() {
    thread_local constinit std::pmr::memory_resource* arena = nullptr;
    return arena;
  }

  std::pmr::memory_resource* before;
};

/// Like std::pmr::polymorphic_allocator, but a copy is allocated where new lists are, and a moved
/// list stays where it is.
template <class T> class InArena {
public:
  using value_type = T;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;

  InArena() = default;
  template <class U> InArena(const InArena<U>& other) : arena(other.resource()) {}

  [[nodiscard]] T* allocate(std::size_t count) {
    return static_cast<T*>(arena->allocate(count * sizeof(T), alignof(T)));
  }
  void deallocate(T* items, std::size_t count) {
    arena->deallocate(items, count * sizeof(T), alignof(T));
  }
  [[nodiscard]] InArena select_on_container_copy_construction() const { return {}; }
  [[nodiscard]] std::pmr::memory_resource* resource() const { return arena; }

  friend bool operator==(const InArena& a, const InArena& b) { return a.arena == b.arena; }

private:
  std::pmr::memory_resource* arena = ArenaScope::current();
};

template <class T> using List = std::vector<T, InArena<T>>;

} // namespace proskill::syntax
