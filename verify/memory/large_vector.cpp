#include "verify/memory/large_vector.h"

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace proskill::verify {

#if defined(MADV_HUGEPAGE) && defined(MAP_ANONYMOUS)

namespace {

/// Bytes from an address to the next one that is a multiple of the size of a large page.
std::size_t bytesToLargePage(const void* address) {
  return -reinterpret_cast<std::uintptr_t>(address) % kLargePage; // NOLINT
}

std::size_t inPages(std::size_t bytes) {
  constexpr std::size_t kPage = std::size_t{1} << 16; // a multiple of all usual sizes
  return (bytes + kPage - 1) / kPage * kPage;
}

} // namespace

/// Large pages begin at multiples of their size, so this asks for more, and gives back what is
/// before the first large page and after the end.
void* allocateLargePages(std::size_t bytes) {
  const std::size_t size = inPages(bytes);
  void* const all = ::mmap(nullptr, size + kLargePage, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (all == MAP_FAILED) throw std::bad_alloc(); // NOLINT: a cast of the system
  const std::size_t before = bytesToLargePage(all);
  auto* const made = static_cast<std::byte*>(all) + before;
  if (before > 0) ::munmap(all, before);
  ::munmap(made + size, kLargePage - before);
  ::madvise(made, size, MADV_HUGEPAGE); // ordinary pages do, too
  return made;
}

void freeLargePages(void* memory, std::size_t bytes) noexcept { ::munmap(memory, inPages(bytes)); }

#else

void* allocateLargePages(std::size_t bytes) { return ::operator new(bytes); }

void freeLargePages(void* memory, std::size_t /*bytes*/) noexcept { ::operator delete(memory); }

#endif

} // namespace proskill::verify
