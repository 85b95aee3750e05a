#include "syntax/text/rational.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace proskill::syntax {
namespace {

Wide gcd(Wide a, Wide b) { return b == 0 ? a : gcd(b, a % b); }

bool fits(Wide value) {
  return value >= std::numeric_limits<std::int64_t>::min() &&
         value <= std::numeric_limits<std::int64_t>::max();
}

std::optional<Rational> lowest(Wide numerator, Wide denominator) {
  Wide divisor = gcd(numerator < 0 ? -numerator : numerator, denominator);
  numerator /= divisor;
  denominator /= divisor;
  if (!fits(numerator) || !fits(denominator)) return std::nullopt;
  return Rational{static_cast<std::int64_t>(numerator), static_cast<std::int64_t>(denominator)};
}

/// Number of decimal places that represent `1/denominator` exactly; nullopt if there is none.
std::optional<int> decimalPlaces(std::int64_t denominator) {
  int twos = 0;
  int fives = 0;
  for (; denominator % 2 == 0; denominator /= 2) ++twos;
  for (; denominator % 5 == 0; denominator /= 5) ++fives;
  if (denominator != 1) return std::nullopt;
  return std::max(twos, fives);
}

} // namespace

std::optional<Rational> parseRational(std::string_view text) {
  bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  // Trailing zeros of a decimal are meaningless, but would make the denominator overflow.
  if (text.contains('.'))
    while (text.ends_with('0')) text.remove_suffix(1);
  constexpr Wide kLimit = Wide{1} << 100;
  Wide numerator = 0;
  Wide denominator = 1;
  bool point = false;
  bool digits = false;
  for (char c : text) {
    if (c == '.' && !point) {
      point = true;
      continue;
    }
    if (c < '0' || c > '9') return std::nullopt;
    digits = true;
    numerator = numerator * 10 + (c - '0');
    if (point) denominator *= 10;
    if (numerator > kLimit || denominator > kLimit) return std::nullopt;
  }
  if (!digits) return std::nullopt;
  return lowest(negative ? -numerator : numerator, denominator);
}

std::optional<Rational> add(Rational a, Rational b) {
  // each product fits into 126 bits, so the sum fits, too
  return lowest(Wide{a.numerator} * b.denominator + Wide{b.numerator} * a.denominator,
                Wide{a.denominator} * b.denominator);
}

std::optional<Rational> multiply(Rational a, Rational b) {
  return lowest(Wide{a.numerator} * b.numerator, Wide{a.denominator} * b.denominator);
}

std::string toString(Rational value) {
  if (value.denominator == 1) return std::to_string(value.numerator);
  auto places = decimalPlaces(value.denominator);
  if (!places) return fmt::format("{}/{}", value.numerator, value.denominator);
  bool negative = value.numerator < 0;
  Wide magnitude = negative ? -Wide{value.numerator} : Wide{value.numerator};
  Wide whole = magnitude / value.denominator;
  Wide part = magnitude % value.denominator;
  std::string digits;
  for (int i = 0; i < *places; ++i) {
    part *= 10;
    digits += static_cast<char>('0' + static_cast<int>(part / value.denominator));
    part %= value.denominator;
  }
  return fmt::format("{}{}.{}", negative ? "-" : "", static_cast<std::int64_t>(whole), digits);
}

} // namespace proskill::syntax
