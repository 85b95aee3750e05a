#include "analysis/flow/inspect.h"
#include "tests/robustness/broken_text.h"
#include "tests/support/random/random_source.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

void standsIn(const std::string& text, const syntax::Range& range) {
  REQUIRE(range.begin <= range.end);
  REQUIRE(range.end <= text.size());
}

/// Parses, checks, runs the flow analysis, and tests that every diagnostic is within the text.
void survives(const std::string& text) {
  analysis::Program program = test::programOfText(text);
  for (const auto& found : analysis::flow::inspect(program, {.style = true})) {
    standsIn(text, found.location.range);
    for (const auto& related : found.related) standsIn(text, related.location.range);
    for (const auto& fix : found.fixes) standsIn(text, fix.location.range);
  }
}

/// The flow even of programs with errors: it is never used for them, but must not fail.
void flows(const std::string& text) {
  analysis::Program program = test::programOfText(text);
  analysis::Analysis analysis = analysis::analyse(program);
  for (const auto& found : analysis::flow::checkFlow(program, analysis.index))
    standsIn(text, found.location.range);
}

} // namespace

TEST_CASE("there are examples to break") { CHECK(test::examples().size() >= 4); }

TEST_CASE("every prefix of every example is a program with diagnostics in it") {
  for (const auto& [name, text] : test::examples()) {
    INFO(name);
    for (std::size_t length = 0; length <= text.size(); ++length) {
      analysis::Program program = test::programOfText(text.substr(0, length));
      for (const auto& found : program.diagnostics) REQUIRE(found.location.range.end <= length);
      if (length % 17 == 0)
        survives(text.substr(0, length)); // the checks too, but not at each byte
      if (length % 61 == 0) flows(text.substr(0, length));
    }
  }
}

TEST_CASE("an example with any one byte missing is a program") {
  for (const auto& [name, text] : test::examples()) {
    INFO(name);
    for (std::size_t at = 0; at < text.size(); at += 17)
      survives(text.substr(0, at) + text.substr(at + 1));
  }
}

TEST_CASE("an example with some statements or definitions missing has a flow") {
  test::RandomSource random(1);
  for (const auto& [name, text] : test::examples())
    for (int i = 0; i < 20; ++i) {
      std::string less = text;
      for (int cuts = 1 + static_cast<int>(random.below(3)); cuts > 0; --cuts) {
        std::size_t begin = less.find('(', random.below(less.size()));
        if (begin == std::string::npos) continue;
        int depth = 0;
        std::size_t end = begin;
        do depth += less[end] == '(' ? 1 : less[end] == ')' ? -1 : 0;
        while (++end < less.size() && depth > 0);
        less.erase(begin, end - begin);
      }
      INFO(name << "\n" << less);
      survives(less);
      flows(less);
    }
}

TEST_CASE("deeply nested statements and conditions have a flow") {
  for (const auto& [open, close] : {std::pair{"(if (v A) ", ")"}, std::pair{"(while (v A) ", ")"},
                                    std::pair{"(do ", " until (v B))"}, std::pair{"(// (", "))"}}) {
    std::string body = "(^ 1)";
    for (int depth = 0; depth < 100; ++depth) body = open + body + close;
    survives("(defsv v :states (A B) :init A)\n(defskill mission :body (" + body + "))\n");
  }
  std::string condition = "(v A)";
  for (int depth = 0; depth < 150; ++depth) condition = "(not " + condition + ")";
  survives("(defsv v :states (A B) :init A)\n(defskill mission :body ((^ " + condition + ")))\n");
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
