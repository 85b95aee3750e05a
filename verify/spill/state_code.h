#pragma once

#include "verify/model/dbm.h"
#include "verify/model/system.h"
#include "verify/spill/paged_file.h"

/// States and zones as bytes.
namespace proskill::verify {

inline constexpr std::uint32_t kBytesOfWord = 8;

/// A word, as its difference from another one: which of its bytes changed, and these.
inline void writeWord(PagedFile& to, Word from, Word word) {
  const Word changed = from ^ word;
  std::uint8_t mask = 0;
  for (std::uint32_t i = 0; i < kBytesOfWord; ++i)
    if ((changed >> 8 * i & 0xFF) != 0) mask |= static_cast<std::uint8_t>(1U << i);
  to.byte(mask);
  for (std::uint32_t i = 0; i < kBytesOfWord; ++i)
    if ((mask >> i & 1) != 0) to.byte(static_cast<std::uint8_t>(changed >> 8 * i));
}

inline void readWord(PageReader& from, Word& word) {
  for (std::uint32_t mask = from.byte(); mask != 0; mask &= mask - 1)
    word ^= Word{from.byte()} << 8 * static_cast<std::uint32_t>(std::countr_zero(mask));
}

/// Numbers as bytes in memory, as a PagedFile has them.
struct ByteText {
  std::string bytes;

  void number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(value | 0x80);
    bytes += static_cast<char>(value);
  }
};

/// A packed state, as its difference from the one before. \param before becomes the state
inline void writeState(PagedFile& to, std::vector<Word>& before, const Word* state) {
  const std::size_t words = before.size();
  if (words == 1) writeWord(to, before[0], state[0]);
  for (std::size_t first = 0; first < words && words > 1; first += 8) {
    const std::size_t end = std::min(words, first + 8);
    std::uint8_t mask = 0;
    for (std::size_t i = first; i < end; ++i)
      if (before[i] != state[i]) mask |= static_cast<std::uint8_t>(1U << (i - first));
    to.byte(mask);
    for (std::size_t i = first; i < end; ++i)
      if (before[i] != state[i]) writeWord(to, before[i], state[i]);
  }
  std::copy_n(state, words, before.begin());
}

/// Reads a state. \param state the one before; becomes the state
inline void readState(PageReader& from, std::vector<Word>& state) {
  if (state.size() == 1) return readWord(from, state[0]);
  for (std::size_t first = 0; first < state.size(); first += 8)
    for (std::uint32_t mask = from.byte(); mask != 0; mask &= mask - 1)
      readWord(from, state[first + static_cast<std::size_t>(std::countr_zero(mask))]);
}

/// States in the order of all files: word by word.
[[nodiscard]] inline std::strong_ordering compareStates(const Word* a, const Word* b,
                                                        std::size_t words) {
  for (std::size_t i = 0; i < words; ++i)
    if (a[i] != b[i]) return a[i] <=> b[i];
  return std::strong_ordering::equal;
}

/// A bound as a number: small if the bound is near 0, 0 for infinity.
[[nodiscard]] inline std::uint32_t codeOf(Bound bound) {
  if (bound == kInfinite) return 0;
  const auto word = static_cast<std::uint32_t>(bound);
  return ((word << 1) ^ (bound < 0 ? UINT32_MAX : 0U)) + 1;
}

/// A zone, whose dimension is known. \param to a PagedFile, or a ByteText
template <class To> void writeZone(To& to, std::uint32_t dimension, std::span<const Bound> matrix) {
  for (std::size_t i = 0; i < matrix.size(); ++i)
    if (i % (dimension + 1) != 0) to.number(codeOf(matrix[i])); // not the diagonal
}
/// Appends the bounds of a zone.
void readZone(PageReader& from, std::uint32_t dimension, std::vector<Bound>& to);

/// Zones in an order in which each precedes those that it includes.
[[nodiscard]] bool precedes(std::span<const Bound> a, std::span<const Bound> b);

} // namespace proskill::verify
