#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace proskill::analysis::flow {

/// A set of small numbers.
class Bits {
public:
  Bits() = default;
  explicit Bits(std::size_t size) : words((size + 63) / 64) {}

  void insert(std::size_t i) { words[i / 64] |= std::uint64_t{1} << (i % 64); }
  void erase(std::size_t i) { words[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
  [[nodiscard]] bool contains(std::size_t i) const { return (words[i / 64] >> (i % 64) & 1) != 0; }
  [[nodiscard]] bool intersects(const Bits& other) const {
    for (std::size_t i = 0; i < words.size(); ++i)
      if ((words[i] & other.words[i]) != 0) return true;
    return false;
  }
  void eraseAll(const Bits& other) {
    for (std::size_t i = 0; i < words.size(); ++i) words[i] &= ~other.words[i];
  }
  /// \return something is new
  bool insertAll(const Bits& other) {
    std::uint64_t added = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
      added |= other.words[i] & ~words[i];
      words[i] |= other.words[i];
    }
    return added != 0;
  }
  friend auto operator<=>(const Bits&, const Bits&) = default;

private:
  template <class Visit> friend void forEach(const Bits& bits, Visit&& visit);
  std::vector<std::uint64_t> words;
};

template <class Visit> void forEach(const Bits& bits, Visit&& visit) {
  for (std::size_t word = 0; word < bits.words.size(); ++word)
    for (std::uint64_t rest = bits.words[word]; rest != 0; rest &= rest - 1)
      visit(word * 64 + static_cast<std::size_t>(std::countr_zero(rest)));
}

} // namespace proskill::analysis::flow
