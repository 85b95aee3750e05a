#include "tests/lsp/support/session.h"
#include "tests/support/chain_program.h"

#include <catch2/catch.hpp>

namespace proskill::test::trace_test {

using test::rangeOf;
using test::Session;

namespace {

constexpr auto kMain = "file:///w/main.proskill";

} // namespace

TEST_CASE("traces that the server does not keep are found when somebody wants to see them") {
  const Json program{{"textDocument", {{"uri", kMain}}}};
  Session session;
  session.initialize();
  session.open(kMain, chainProgram(30));
  const auto result = session.result("proskill/verify", program);
  std::size_t steps = 0;
  Json longest;
  for (const auto& verdict : result["verdicts"]) {
    if (verdict["steps"].is_null()) continue;
    steps += verdict["steps"].get<std::size_t>();
    if (longest.is_null() || verdict["steps"] > longest["steps"]) longest = verdict;
  }
  CHECK(steps > 4000); // twice as many as are kept
  auto params = program;
  params["name"] = longest["name"];
  const auto trace = session.result("proskill/trace", params);
  CHECK(trace["steps"].size() == longest["steps"]);
  CHECK(trace["verdict"] == longest["verdict"]);
  CHECK(trace["stale"] == false);
  session.change(kMain, 2, rangeOf(0, 0, 0), "; shifts the texts\n");
  const auto stale = session.result("proskill/trace", params);
  CHECK(stale["stale"] == true);
  CHECK(stale["steps"].size() == longest["steps"]);
}

} // namespace proskill::test::trace_test
