#include "syntax/text/rational.h"
#include "syntax/text/seconds.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace proskill::syntax;

TEST_CASE("decimals are exact fractions in lowest terms") {
  CHECK(parseRational("12") == Rational{12, 1});
  CHECK(parseRational("-3") == Rational{-3, 1});
  CHECK(parseRational("0.25") == Rational{1, 4});
  CHECK(parseRational("-0.10") == Rational{-1, 10});
  CHECK(parseRational("0") == Rational{0, 1});
  CHECK(parseRational("1.50000000000000000000000000000000000000") == Rational{3, 2});
}

TEST_CASE("what is no number, or has too many digits, is nothing") {
  CHECK_FALSE(parseRational(""));
  CHECK_FALSE(parseRational("-"));
  CHECK_FALSE(parseRational("1.2.3"));
  CHECK_FALSE(parseRational("x"));
  CHECK(parseRational("9223372036854775807") == Rational{std::numeric_limits<std::int64_t>::max()});
  CHECK(parseRational("-9223372036854775808") ==
        Rational{std::numeric_limits<std::int64_t>::min()});
  CHECK_FALSE(parseRational("9223372036854775808"));
  CHECK_FALSE(parseRational("0.00000000000000000001"));
  CHECK_FALSE(parseRational(std::string(1000, '9')));
}

TEST_CASE("sums and products, as long as they fit") {
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  CHECK(add({1, 2}, {1, 3}) == Rational{5, 6});
  CHECK(add({1, 2}, {-1, 2}) == Rational{0, 1});
  CHECK(multiply({2, 3}, {3, 4}) == Rational{1, 2});
  CHECK(multiply({kMost, 1}, {1, kMost}) == Rational{1, 1});
  CHECK_FALSE(add({kMost, 1}, {1, 1}));
  CHECK_FALSE(multiply({kMost, 1}, {2, 1}));
  CHECK_FALSE(add({1, kMost}, {1, kMost - 1}));
}

TEST_CASE("comparison is exact") {
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  CHECK(Rational{1, 3} < Rational{1, 2});
  CHECK(Rational{-1, 2} < Rational{0, 1});
  CHECK(Rational{kMost - 1, kMost} < Rational{1, 1});
}

TEST_CASE("numbers are written as decimals where they are some") {
  CHECK(toString({3, 1}) == "3");
  CHECK(toString({1, 4}) == "0.25");
  CHECK(toString({-1, 10}) == "-0.1");
  CHECK(toString({7, 2}) == "3.5");
  CHECK(toString({1, 3}) == "1/3");
  CHECK(toString({-22, 7}) == "-22/7");
}

TEST_CASE("seconds are read as decimals, with the fraction where a decimal is not exact") {
  CHECK(secondsText({4, 1}) == "4 s");
  CHECK(secondsText({1, 4}) == "0.25 s");
  CHECK(secondsText({23, 11}) == "about 2.09 s (23/11)");
  CHECK(secondsText({1321, 11}) == "about 120.09 s (1321/11)");
  CHECK(secondsText({1, 3000}) == "about 0.00033 s (1/3000)");
}
