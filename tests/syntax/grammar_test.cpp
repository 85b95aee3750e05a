#include "syntax/text/scan.h"
#include "syntax/tree/tree.h"
#include "tests/syntax/programs.h"
#include "tests/syntax/random_words.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::NodeKind;
using syntax::Parser;
using syntax::Tree;

/// The grammar alone, without Document.
namespace {

bool hasError(const Tree& tree) {
  return std::ranges::any_of(tree,
                             [](const syntax::Node& node) { return node.kind == NodeKind::Error; });
}

} // namespace

TEST_CASE("the grammar takes every text") {
  Parser parser;
  test::RandomSource random(3);
  for (int i = 0; i < 20'000; ++i) {
    auto text = test::randomWords(random);
    INFO(text);
    REQUIRE_FALSE(hasError(parser.parse(text)));
  }
}

TEST_CASE("the grammar takes every prefix of every program, and every rest") {
  Parser parser;
  for (const auto& program : test::allPrograms()) {
    auto text = std::string_view(program).substr(0, 3000);
    for (std::size_t at = 0; at <= text.size(); at += 3) {
      INFO(text.substr(0, at));
      REQUIRE_FALSE(hasError(parser.parse(text.substr(0, at))));
      REQUIRE_FALSE(hasError(parser.parse(text.substr(at))));
    }
  }
}

TEST_CASE("damage before a definition leaves its tree as it is alone") {
  Parser parser;
  test::RandomSource random(5);
  const std::string definition = "(defsv battery\n  :states (Good Low)\n  :init Good)\n";
  Tree alone = parser.parse(definition);
  for (int i = 0; i < 5'000; ++i) {
    auto damage = test::randomWords(random) + "\n";
    Tree together = parser.parse(damage + definition);
    INFO(damage + definition);
    REQUIRE(together.size() >= alone.size() - 1);
    // All but the root, which is the first node.
    for (std::size_t n = 1; n < alone.size(); ++n) {
      auto node = together[together.size() - alone.size() + n];
      node.range.begin -= static_cast<syntax::Offset>(damage.size());
      node.range.end -= static_cast<syntax::Offset>(damage.size());
      REQUIRE(node == alone[n]);
    }
  }
}

TEST_CASE("a text is cut where a line begins with a definition") {
  std::string_view text = "; first\n(defsv a)\n (defsv b)\n(defsvx c)\n\"(\n(include \"d\")\n";
  auto regions = syntax::cut(text);
  REQUIRE(regions.size() == 3);
  CHECK(text.substr(regions[1].begin, 8) == "(defsv a");
  CHECK(text.substr(regions[2].begin, 8) == "(include");
  CHECK(regions[2].end == text.size());
  CHECK(syntax::cut("").empty());
  CHECK(syntax::cut("(defsv a)").size() == 1);
}
