#include "analysis/flow/inspect.h"
#include "syntax/diagnostics/codes.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

namespace proskill::test::inspect_test {

using analysis::flow::Settings;
using syntax::Code;
using syntax::Severity;

namespace {

std::string codes(const std::string& text, const Settings& settings = {}) {
  auto program = test::programOfText(text);
  std::string found;
  for (const auto& each : analysis::flow::inspect(program, settings))
    found += (found.empty() ? "" : " ") + std::string(syntax::info(each.code).id);
  return found;
}

const std::string kGrip = "(defskill grip :action (grip) :failure slipped)\n";

} // namespace

TEST_CASE("A comment on the line before leaves a finding out") {
  CHECK(codes(kGrip + "(defskill mission :body (\n(grip)))") == "PS0708");
  CHECK(codes(kGrip + "(defskill mission :body (\n; proskill-ignore: PS0708\n(grip)))") == "");
  CHECK(codes(kGrip + "(defskill mission :body (\n; proskill-ignore: PS0708, PS0601\n(grip)))") ==
        "PS1201");
  CHECK(codes(kGrip + "(defskill mission :body (\n; proskill-ignore: PS0708\n\n(grip)))") ==
        "PS1201 PS0708");
}

TEST_CASE("Comments that ignore may stand above each other") {
  CHECK(codes(kGrip + "(defskill mission :body (\n; proskill-ignore: PS0601\n"
                      "; proskill-ignore: PS0708\n(grip)))") == "PS1201");
}

TEST_CASE("A code that is none is told") {
  CHECK(codes("; proskill-ignore: it\n(defskill mission :body ((^ 1)))") == "PS1202");
}

TEST_CASE("Errors of names cannot be ignored, and silence the flow") {
  CHECK(codes("; proskill-ignore: PS0203\n(defskill mission :body ((nobody) (^ 0)))")
            .starts_with("PS1201") == true);
  CHECK(codes("(defskill mission :body ((nobody) (^ 0)))").find("PS1005") == std::string::npos);
}

TEST_CASE("Severities are those of the settings") {
  std::string text = kGrip + "(defskill mission :body ((grip)))";
  CHECK(codes(text, {.severities = {{Code::ResultIgnored, std::nullopt}}}) == "");
  auto program = test::programOfText(text);
  auto found = analysis::flow::inspect(
      program, Settings{.severities = {{Code::ResultIgnored, Severity::Error}}});
  REQUIRE(found.size() == 1);
  CHECK(found[0].severity == Severity::Error);
}

TEST_CASE("Hints of style come when they are asked for") {
  std::string text = "(defskill Mission :body ((^ 1)))";
  CHECK(codes(text) == "");
  CHECK(codes(text, {.style = true}) == "PS1101");
  CHECK(codes(text, {.severities = {{Code::NameNotLowerCase, Severity::Hint}}}) == "PS1101");
}

} // namespace proskill::test::inspect_test
