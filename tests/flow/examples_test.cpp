#include "tests/flow/analysed.h"

#include "analysis/flow/inspect.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;

namespace {

bool isOfFlow(const syntax::CodeInfo& info) { return info.id >= "PS0500" && info.id < "PS1300"; }

} // namespace

TEST_CASE(
    "Each diagnostic of the flow is raised by its example, and the example has no other fault") {
  for (const syntax::CodeInfo& info : syntax::allCodes()) {
    if (!isOfFlow(info)) continue;
    INFO(info.id << "\n" << info.example);
    auto program = test::programOf(std::string(info.example));
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
