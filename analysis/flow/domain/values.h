#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

/// Abstract values of variables. A domain is split into at most 64 classes, and a set of values is
/// a set of classes. A small domain has a class for each value, so sets are exact. A large domain
/// is split at the numbers with which the program compares or which it assigns. All sets are
/// finite, so no fixed point needs widening.
namespace proskill::analysis::flow {

/// A set of classes of one domain.
class ValueSet {
public:
  constexpr ValueSet() = default;
  static constexpr ValueSet of(unsigned index) { return ValueSet(std::uint64_t{1} << index); }
  /// The first `count` classes.
  static constexpr ValueSet firstOf(unsigned count) {
    return ValueSet(count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1);
  }

  [[nodiscard]] constexpr bool empty() const { return bits == 0; }
  [[nodiscard]] constexpr bool contains(unsigned index) const { return (bits >> index & 1) != 0; }
  [[nodiscard]] constexpr bool within(ValueSet other) const { return (bits & ~other.bits) == 0; }
  [[nodiscard]] constexpr unsigned count() const { return std::popcount(bits); }
  /// The lowest class. \pre the set is not empty
  [[nodiscard]] constexpr unsigned first() const { return std::countr_zero(bits); }
  constexpr void removeFirst() { bits &= bits - 1; }

  friend constexpr ValueSet operator|(ValueSet a, ValueSet b) { return ValueSet(a.bits | b.bits); }
  friend constexpr ValueSet operator&(ValueSet a, ValueSet b) { return ValueSet(a.bits & b.bits); }
  friend constexpr ValueSet operator-(ValueSet a, ValueSet b) { return ValueSet(a.bits & ~b.bits); }
  constexpr ValueSet& operator|=(ValueSet other) { return *this = *this | other; }
  constexpr ValueSet& operator&=(ValueSet other) { return *this = *this & other; }
  friend constexpr bool operator==(ValueSet, ValueSet) = default;

private:
  explicit constexpr ValueSet(std::uint64_t bits) : bits(bits) {}
  std::uint64_t bits = 0;
};

/// Calls `visit` with the index of each class of a set.
template <class Visit> void forEach(ValueSet set, Visit&& visit) {
  for (; !set.empty(); set.removeFirst()) visit(set.first());
}

/// Integers from `first` to `last`, both included.
struct Span {
  std::int64_t first = 0;
  std::int64_t last = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

/// The possible values of a variable: numbers, or words, represented by their index in the list.
class Domain {
public:
  static Domain ofWords(std::vector<std::string_view> words);
  /// `min..max`, split at each number of `cuts` if it has more than 64 values. \pre min <= max
  static Domain ofNumbers(std::int64_t min, std::int64_t max, std::span<const std::int64_t> cuts);

  [[nodiscard]] unsigned size() const { return static_cast<unsigned>(classes.size()); }
  [[nodiscard]] ValueSet all() const { return ValueSet::firstOf(size()); }
  [[nodiscard]] Span at(unsigned index) const { return classes[index]; }
  [[nodiscard]] std::int64_t min() const { return classes.front().first; }
  [[nodiscard]] std::int64_t max() const { return classes.back().last; }
  [[nodiscard]] bool isNumeric() const { return words.empty(); }

  [[nodiscard]] std::optional<std::int64_t> numberOf(std::string_view word) const;
  [[nodiscard]] std::string_view word(std::int64_t number) const { return words[number]; }
  [[nodiscard]] const std::vector<std::string_view>& allWords() const { return words; }
  /// The classes that contain a number of the span.
  [[nodiscard]] ValueSet touching(Span span) const;
  /// The same after numbers outside of the domain are replaced by its nearest end.
  [[nodiscard]] ValueSet saturated(Span span) const;

private:
  std::vector<std::string_view> words;
  std::vector<Span> classes; ///< in order, without gaps, at least one
};

} // namespace proskill::analysis::flow
