#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace proskill::verify {

/// A growing set of small integers.
class Bits {
public:
  void insert(std::uint32_t i) {
    if (i / 64 >= words.size()) words.resize(i / 64 + 1);
    words[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  void erase(std::uint32_t i) {
    if (i / 64 < words.size()) words[i / 64] &= ~(std::uint64_t{1} << (i % 64));
  }
  [[nodiscard]] bool contains(std::uint32_t i) const {
    return i / 64 < words.size() && (words[i / 64] >> (i % 64) & 1) != 0;
  }
  [[nodiscard]] bool empty() const {
    for (auto word : words)
      if (word != 0) return false;
    return true;
  }
  [[nodiscard]] std::uint32_t count() const {
    std::uint32_t total = 0;
    for (auto word : words) total += std::popcount(word);
    return total;
  }
  Bits& operator|=(const Bits& other) {
    if (other.words.size() > words.size()) words.resize(other.words.size());
    for (std::size_t i = 0; i < other.words.size(); ++i) words[i] |= other.words[i];
    return *this;
  }
  Bits& operator-=(const Bits& other) {
    for (std::size_t i = 0; i < words.size() && i < other.words.size(); ++i)
      words[i] &= ~other.words[i];
    return *this;
  }
  Bits& operator&=(const Bits& other) {
    if (words.size() > other.words.size()) words.resize(other.words.size());
    for (std::size_t i = 0; i < words.size(); ++i) words[i] &= other.words[i];
    return *this;
  }
  [[nodiscard]] bool isWithin(const Bits& other) const {
    for (std::size_t i = 0; i < words.size(); ++i)
      if ((words[i] & ~(i < other.words.size() ? other.words[i] : 0)) != 0) return false;
    return true;
  }
  [[nodiscard]] bool meets(const Bits& other) const {
    for (std::size_t i = 0; i < words.size() && i < other.words.size(); ++i)
      if ((words[i] & other.words[i]) != 0) return true;
    return false;
  }
  [[nodiscard]] std::uint64_t bytes() const { return words.capacity() * sizeof(std::uint64_t); }
  template <class Visit> void each(Visit visit) const {
    for (std::size_t i = 0; i < words.size(); ++i)
      for (auto rest = words[i]; rest != 0; rest &= rest - 1)
        visit(static_cast<std::uint32_t>(i * 64 + std::countr_zero(rest)));
  }
  friend bool operator==(const Bits& a, const Bits& b) {
    const auto& longer = a.words.size() > b.words.size() ? a.words : b.words;
    const auto& shorter = a.words.size() > b.words.size() ? b.words : a.words;
    for (std::size_t i = 0; i < longer.size(); ++i)
      if (longer[i] != (i < shorter.size() ? shorter[i] : 0)) return false;
    return true;
  }

private:
  std::vector<std::uint64_t> words;
};

} // namespace proskill::verify
