#include "syntax/codes.h"
#include "tests/analysis/findings.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace proskill;

namespace {

/// Those that no single text of a sensible size raises: their own tests do.
bool needsMoreThanAText(syntax::Code code) {
  return code == syntax::Code::TextTooLong || code == syntax::Code::FormTooLarge ||
         code == syntax::Code::NestedTooDeep || code == syntax::Code::IncludeCycle;
}

/// From `PS0200` on: what a program means, as far as it is told without running it.
bool isAboutMeaning(const syntax::CodeInfo& code) {
  return code.id >= "PS0200" && code.id < test::kFirstOfFlow;
}

} // namespace

TEST_CASE("each code is raised by its example") {
  for (const syntax::CodeInfo& code : syntax::allCodes()) {
    if (code.id >= test::kFirstOfFlow) continue;
    INFO(code.id);
    CHECK(code.example.empty() == needsMoreThanAText(code.code));
    if (code.example.empty()) continue;
    const auto found = test::diagnose(std::string(code.example));
    CHECK(std::ranges::count(found, code.code, &syntax::Diagnostic::code) > 0);
  }
}

TEST_CASE("the example of a code about meaning has no other mistake") {
  for (const syntax::CodeInfo& code : syntax::allCodes()) {
    if (!isAboutMeaning(code)) continue;
    INFO(code.id);
    const auto found = test::diagnose(std::string(code.example));
    REQUIRE(found.size() == 1);
    CHECK(found[0].severity == code.severity);
  }
}

TEST_CASE("an include cycle is told where it closes, with the way there") {
  const test::MemoryFiles files(
      {{"a.proskill", "(include \"b.proskill\")"}, {"b.proskill", "(include \"a.proskill\")"}});
  const auto found = analysis::check(analysis::load(files, "a.proskill"));
  REQUIRE(found.size() == 1);
  CHECK(found[0].code == syntax::Code::IncludeCycle);
  CHECK(found[0].location.file == 1);
  REQUIRE(found[0].related.size() == 1);
  CHECK(found[0].related[0].location.file == 0);
}

TEST_CASE("codes are unique, have their form, and explain themselves") {
  std::set<std::string_view> seen;
  for (const syntax::CodeInfo& code : syntax::allCodes()) {
    INFO(code.id);
    CHECK(code.id.size() == 6);
    CHECK(code.id.starts_with("PS"));
    CHECK(seen.insert(code.id).second);
    CHECK(code.explanation.size() > 40);
    CHECK(syntax::findCode(code.id)->code == code.code);
  }
}
