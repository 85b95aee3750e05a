#include "syntax/diagnostics/codes.h"
#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

#include <set>

using namespace proskill;
using syntax::Document;

TEST_CASE("each diagnostic of form is raised by its example, and nothing else is") {
  for (const auto& entry : syntax::allCodes()) {
    // from PS0006 on, PS00xx concern files, which a text alone does not have
    bool ofForm = entry.id < "PS0006" || entry.id.starts_with("PS01");
    if (!ofForm || entry.example.empty()) continue;
    INFO(entry.example);
    CHECK(test::codesOf(Document::parse(std::string(entry.example))) == entry.id);
  }
}

TEST_CASE("codes are unique, found in any case, and explained") {
  std::set<std::string_view> ids;
  for (const auto& entry : syntax::allCodes()) {
    INFO(entry.id);
    CHECK(ids.insert(entry.id).second);
    CHECK(syntax::findCode(entry.id) == &syntax::info(entry.code));
    CHECK(entry.explanation.size() > 40);
    CHECK_FALSE(entry.message.ends_with('.'));
  }
  CHECK(syntax::findCode("ps0101") == &syntax::info(syntax::Code::UnclosedParenthesis));
  CHECK(syntax::findCode("PS9999") == nullptr);
}

TEST_CASE("the fix of a diagnostic, applied, leaves nothing wrong") {
  for (std::string_view program : {
           "(defevent gust :effects (motion Free) (camera Off))",
           "(defevent take-off :effects (motion Free))",
           "(defskill greet :body ((printf \"hello)))",
           "(defskill fly :body ((// (takeoff) ((camera_survey)))))",
           "(defskill fly :body (takeoff height 3))",
           "(defskill fly :body ((takeoff) landing))",
           "(defskill fly :body ((takeoff.stop)))",
           "(defskill fly :body ((takeoff.)))",
           "(defsv light\n  :states (Off On\n  :init Off)",
           "(defsv light\n  :states (Off On)\n  :init Off",
           "(defsv light\n  :states (Off On))\n  :init Off)",
       }) {
    auto document = Document::parse(std::string(program));
    INFO(program);
    REQUIRE(document.diagnostics().size() == 1);
    REQUIRE(document.diagnostics()[0].fixes.size() == 1);
    const auto& fix = document.diagnostics()[0].fixes[0];
    auto fixed = document.edit(fix.location.range, fix.text);
    INFO(fixed.text());
    CHECK(test::codesOf(fixed) == "");
  }
}
