#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

/// Large tables in large pages of memory. Entries that are looked up at random are in a different
/// page each, and the processor keeps the addresses of some thousand pages only.
namespace proskill::verify {

inline constexpr std::size_t kLargePage = std::size_t{2} << 20; ///< bytes
/// Tables below this have ordinary pages, so that small searches need no more memory.
inline constexpr std::size_t kLargeTable = std::size_t{4} << 20; ///< bytes

/// Memory in large pages, if the system has some. What is never written takes none.
/// \throw std::bad_alloc
[[nodiscard]] void* allocateLargePages(std::size_t bytes);
/// \param bytes as they were asked for
void freeLargePages(void* memory, std::size_t bytes) noexcept;

/// Allocates large tables in large pages. Their memory is given back as soon as it is freed.
template <class T> struct LargePageAllocator {
  using value_type = T;

  LargePageAllocator() = default;
  template <class Other>
  LargePageAllocator(const LargePageAllocator<Other>& /*other*/) {} // NOLINT: containers convert

  [[nodiscard]] T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    return static_cast<T*>(bytes < kLargeTable ? ::operator new(bytes) : allocateLargePages(bytes));
  }
  void deallocate(T* memory, std::size_t count) noexcept {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < kLargeTable)
      ::operator delete(memory);
    else
      freeLargePages(memory, bytes);
  }
  friend bool operator==(const LargePageAllocator&, const LargePageAllocator&) = default;
};

/// A vector that may have millions of elements.
template <class T> using LargeVector = std::vector<T, LargePageAllocator<T>>;

/// Growing tables are checked against the limits at least every so many insertions.
inline constexpr std::size_t kBetweenGrowthChecks = 4096;

/// Additional bytes that a vector will allocate when it grows, if that is soon; otherwise 0.
/// \param soon the elements that may be added before the next check
template <class T, class Allocator>
[[nodiscard]] std::uint64_t growthOf(const std::vector<T, Allocator>& all,
                                     std::size_t soon = kBetweenGrowthChecks) {
  if (all.capacity() - all.size() > soon) return 0;
  return all.capacity() * sizeof(T);
}

/// The same, and the large pages that will be used for the first time.
template <class T>
[[nodiscard]] std::uint64_t growthOf(const LargeVector<T>& all,
                                     std::size_t soon = kBetweenGrowthChecks) {
  if (all.capacity() * sizeof(T) < kLargeTable || all.capacity() - all.size() <= soon)
    return growthOf<T, LargePageAllocator<T>>(all, soon);
  const auto pagesFor = [](std::size_t count) {
    return (count * sizeof(T) + kLargePage - 1) / kLargePage;
  };
  return (pagesFor(all.size() + soon) - pagesFor(all.size())) * kLargePage;
}

} // namespace proskill::verify
