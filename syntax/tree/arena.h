#pragma once

#include <cstddef>
#include <memory_resource>
#include <type_traits>
#include <utility>
#include <vector>

/// Forms that are read together lie together in memory that is given back as a whole: to copy them
/// takes half as long, and to destroy them next to nothing.
namespace proskill::syntax {

/// While it lives, lists that are made by its thread lie in a resource, which outlives them.
class ArenaScope {
public:
  explicit ArenaScope(std::pmr::memory_resource& arena) : before(std::exchange(inUse(), &arena)) {}
  ~ArenaScope() { inUse() = before; }
  ArenaScope(const ArenaScope&) = delete;
  ArenaScope& operator=(const ArenaScope&) = delete;

  /// That of the innermost scope; the free store outside of all.
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

/// As std::pmr::polymorphic_allocator, but that a copy lies where others are being made, and what
/// is moved stays where it is.
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
