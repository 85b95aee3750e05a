#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace proskill::syntax {

__extension__ using Wide = __int128; ///< holds the product of two 64-bit integers

/// An exact fraction in lowest terms with a positive denominator. Durations are rationals in
/// seconds.
struct Rational {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;

  friend bool operator==(const Rational&, const Rational&) = default;
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return Wide{a.numerator} * b.denominator <=> Wide{b.numerator} * a.denominator;
  }
};

/// Parses `12`, `-3` or `0.25` exactly; nothing if the value does not fit 64 bits.
[[nodiscard]] std::optional<Rational> parseRational(std::string_view text);
[[nodiscard]] std::optional<Rational> add(Rational a, Rational b);
[[nodiscard]] std::optional<Rational> multiply(Rational a, Rational b);
/// The shortest decimal if there is one (`0.25`), otherwise the fraction (`1/3`).
[[nodiscard]] std::string toString(Rational value);

} // namespace proskill::syntax
