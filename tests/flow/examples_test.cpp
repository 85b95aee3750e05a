#include "analysis/flow/inspect.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;

namespace {

bool isOfFlow(const syntax::CodeInfo& info) { return info.id >= "PS0500" && info.id < "PS1300"; }

std::vector<syntax::Diagnostic> found(const std::string& text) {
  return analysis::flow::inspect(test::programOfText(text), {.style = true});
}

} // namespace

TEST_CASE("The edit that comes with a diagnostic of the flow fixes its example") {
  std::size_t fixes = 0;
  for (const syntax::CodeInfo& info : syntax::allCodes()) {
    if (!isOfFlow(info)) continue;
    for (const auto& each : found(std::string(info.example))) {
      if (each.code != info.code) continue;
      for (const syntax::Fix& fix : each.fixes) {
        std::string fixed(info.example);
        fixed.replace(fix.location.range.begin, fix.location.range.length(), fix.text);
        INFO(info.id << " " << fix.title << "\n" << fixed);
        for (const auto& left : found(fixed)) {
          INFO(syntax::info(left.code).id << ": " << left.message);
          CHECK(left.code != info.code);
          CHECK(left.severity == syntax::Severity::Hint);
        }
        ++fixes;
      }
    }
  }
  CHECK(fixes > 12);
}

TEST_CASE(
    "Each diagnostic of the flow is raised by its example, and the example has no other fault") {
  for (const syntax::CodeInfo& info : syntax::allCodes()) {
    if (!isOfFlow(info)) continue;
    INFO(info.id << "\n" << info.example);
    auto program = test::programOfText(std::string(info.example));
    auto analysis = analysis::analyse(program);
    for (const auto& each : analysis.diagnostics) {
      INFO(each.message);
      CHECK(each.severity != syntax::Severity::Error);
    }
    auto found = analysis::flow::inspect(program, analysis, {.style = true});
    CHECK(std::ranges::count(found, info.code, &syntax::Diagnostic::code) == 1);
    for (const auto& each : found) {
      INFO(syntax::info(each.code).id << ": " << each.message);
      bool own = each.code == info.code || each.severity == syntax::Severity::Hint;
      CHECK(own);
    }
  }
}
