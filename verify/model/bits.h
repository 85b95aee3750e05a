#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace proskill::verify {

/// A growing set of small integers. Those below 128 take no memory of their own, since most sets
/// of most systems have no others.
class Bits {
public:
  void insert(std::uint32_t i) {
    grow(i / 64 + 1);
    word(i / 64) |= bit(i);
  }
  void erase(std::uint32_t i) {
    if (i / 64 < size()) word(i / 64) &= ~bit(i);
  }
  [[nodiscard]] bool contains(std::uint32_t i) const {
    return i / 64 < size() && (word(i / 64) & bit(i)) != 0;
  }
  [[nodiscard]] bool empty() const {
    for (std::size_t i = 0; i < size(); ++i)
      if (word(i) != 0) return false;
    return true;
  }
  [[nodiscard]] std::uint32_t count() const {
    std::uint32_t total = 0;
    for (std::size_t i = 0; i < size(); ++i) total += std::popcount(word(i));
    return total;
  }
  Bits& operator|=(const Bits& other) {
    grow(other.size());
    for (std::size_t i = 0; i < other.size(); ++i) word(i) |= other.word(i);
    return *this;
  }
  Bits& operator-=(const Bits& other) {
    for (std::size_t i = 0; i < size(); ++i) word(i) &= ~other.wordOr0(i);
    return *this;
  }
  Bits& operator&=(const Bits& other) {
    for (std::size_t i = 0; i < size(); ++i) word(i) &= other.wordOr0(i);
    return *this;
  }
  [[nodiscard]] bool isWithin(const Bits& other) const {
    for (std::size_t i = 0; i < size(); ++i)
      if ((word(i) & ~other.wordOr0(i)) != 0) return false;
    return true;
  }
  [[nodiscard]] bool meets(const Bits& other) const {
    for (std::size_t i = 0; i < size(); ++i)
      if ((word(i) & other.wordOr0(i)) != 0) return true;
    return false;
  }
  [[nodiscard]] std::uint64_t bytes() const { return more.capacity() * sizeof(std::uint64_t); }
  template <class Visit> void each(Visit visit) const {
    for (std::size_t i = 0; i < size(); ++i)
      for (auto rest = word(i); rest != 0; rest &= rest - 1)
        visit(static_cast<std::uint32_t>(i * 64 + std::countr_zero(rest)));
  }
  friend bool operator==(const Bits& a, const Bits& b) { return a.isWithin(b) && b.isWithin(a); }

private:
  static constexpr std::size_t kFew = 2;

  [[nodiscard]] static std::uint64_t bit(std::uint32_t i) { return std::uint64_t{1} << (i % 64); }
  [[nodiscard]] std::size_t size() const { return kFew + more.size(); }
  void grow(std::size_t words) {
    if (words > size()) more.resize(words - kFew);
  }
  [[nodiscard]] std::uint64_t& word(std::size_t i) { return i < kFew ? few[i] : more[i - kFew]; }
  [[nodiscard]] std::uint64_t word(std::size_t i) const {
    return i < kFew ? few[i] : more[i - kFew];
  }
  [[nodiscard]] std::uint64_t wordOr0(std::size_t i) const { return i < size() ? word(i) : 0; }

  std::array<std::uint64_t, kFew> few{};
  std::vector<std::uint64_t> more;
};

} // namespace proskill::verify
