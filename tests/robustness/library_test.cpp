#include "tests/robustness/broken_text.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

/// Parses and checks, and looks that every diagnostic stands in the text.
void survives(const std::string& text) {
  analysis::Program program = test::programOfText(text);
  for (const auto& found : analysis::check(program)) {
    REQUIRE(found.location.range.begin <= found.location.range.end);
    REQUIRE(found.location.range.end <= text.size());
  }
}

} // namespace

TEST_CASE("there are examples to break") { CHECK(test::examples().size() >= 4); }

TEST_CASE("every prefix of every example is a program with diagnostics in it") {
  for (const auto& [name, text] : test::examples()) {
    INFO(name);
    for (std::size_t length = 0; length <= text.size(); ++length) {
      analysis::Program program = test::programOfText(text.substr(0, length));
      for (const auto& found : program.diagnostics) REQUIRE(found.location.range.end <= length);
      if (length % 7 == 0) survives(text.substr(0, length)); // the checks too, but not at each byte
    }
  }
}

TEST_CASE("an example with any one byte missing is a program") {
  for (const auto& [name, text] : test::examples()) {
    INFO(name);
    for (std::size_t at = 0; at < text.size(); at += 11)
      survives(text.substr(0, at) + text.substr(at + 1));
  }
}

TEST_CASE("any bytes are a program") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    INFO("seed " << seed);
    survives(test::randomBytes(seed, 1 + seed * 5));
    survives(test::randomWords(seed, 1 + seed));
  }
}

TEST_CASE("texts that are broken in one way each are programs") {
  for (const auto& [name, text] : test::brokenTexts()) {
    INFO(name);
    survives(text);
  }
}
