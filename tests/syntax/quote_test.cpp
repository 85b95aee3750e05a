#include "syntax/text/quote.h"

#include "syntax/diagnostics/codes.h"
#include "syntax/document.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::shortened;
using syntax::withShortQuotes;

TEST_CASE("of a text a message quotes the first line, and not all of a long one") {
  CHECK(shortened("") == "");
  CHECK(shortened("takeoff") == "takeoff");
  CHECK(shortened("(takeoff\n height 3)") == "(takeoff...");
  CHECK(shortened(std::string(60, 'x')) == std::string(60, 'x'));
  CHECK(shortened(std::string(61, 'x')) == std::string(60, 'x') + "...");
  CHECK(shortened(std::string(59, 'x') + "é" + "y") == std::string(59, 'x') + "...");
}

TEST_CASE("what a message quotes is shortened, and nothing else") {
  const std::string endless(1000, 'x');
  const std::string shown = std::string(60, 'x') + "...";
  CHECK(withShortQuotes("`a` and `b`") == "`a` and `b`");
  CHECK(withShortQuotes("`" + endless + "` is no `" + endless + "`, but " + endless) ==
        "`" + shown + "` is no `" + shown + "`, but " + endless);
  CHECK(withShortQuotes("open `") == "open `");
}

TEST_CASE("a message that is filled in quotes a word of a text shortly, whatever is in it") {
  const std::string odd = "a`b`" + std::string(100, '-');
  auto found = syntax::makeDiagnostic(syntax::Code::MalformedName, {}, odd);
  CHECK(found.message == "`a`b`" + std::string(56, '-') + "...` is not a name");
  found = syntax::makeDiagnostic(syntax::Code::MalformedName, {}, "a", "more than it says");
  CHECK(found.message == "`a` is not a name");
  found = syntax::makeDiagnostic(syntax::Code::UnreadableFile, {}, odd, "there is none: `x`");
  CHECK(found.message == "cannot read `a`b`" + std::string(56, '-') + "...`: there is none: `x`");
}

TEST_CASE("a word of a megabyte is told by its beginning") {
  const auto document =
      syntax::Document::parse("(defsv " + std::string(1 << 20, '-') + "a :states (A) :init A)");
  REQUIRE_FALSE(document.diagnostics().empty());
  for (const auto& it : document.diagnostics()) {
    CHECK(it.message.size() < 200);
    for (const auto& fix : it.fixes) CHECK(fix.title.size() < 200);
  }
}
