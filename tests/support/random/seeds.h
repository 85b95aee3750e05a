#pragma once

#include <cstdint>
#include <cstdlib>

namespace proskill::test {

/// Seeds of random programs, from `first` on, before `end`.
struct Seeds {
  std::uint64_t first = 0;
  std::uint64_t end = 0;
};

/// `PROSKILL_SEEDS=FIRST:COUNT` selects other seeds than the default.
inline Seeds seedsOr(std::uint64_t first, std::uint64_t count) {
  const char* asked = std::getenv("PROSKILL_SEEDS");
  if (!asked) return {first, first + count};
  char* rest = nullptr;
  const std::uint64_t from = std::strtoull(asked, &rest, 10);
  return {from, from + (*rest == ':' ? std::strtoull(rest + 1, nullptr, 10) : 0)};
}

} // namespace proskill::test
