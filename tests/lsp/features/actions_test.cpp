#include "tests/lsp/support/session.h"

#include <catch2/catch.hpp>

using namespace proskill;
using test::Session;

namespace {

constexpr auto kMain = "file:///w/main.proskill";
constexpr auto kText = "; \U0001f600\n(defsv lamp :states (On Off) :init Of) ; \U0001f600\n";

Json actions(Session& session, Json context) {
  return session.result("textDocument/codeAction", {{"textDocument", {{"uri", kMain}}},
                                                    {"range", test::rangeOf(1, 37, 37)},
                                                    {"context", std::move(context)}});
}

} // namespace

TEST_CASE("code actions of the kinds that are asked for") {
  Session session;
  session.initialize();
  session.open(kMain, kText);
  auto fixes = actions(session, {{"diagnostics", Json::array()}, {"only", {"quickfix"}}});
  REQUIRE(fixes.size() == 2);
  CHECK(fixes[0]["kind"] == "quickfix");
  CHECK(fixes[0]["isPreferred"] == true);
  CHECK(fixes[0]["diagnostics"][0]["code"] == "PS0203");
  auto all = actions(session, {{"diagnostics", Json::array()}, {"only", {"source"}}});
  REQUIRE(all.size() == 1);
  CHECK(all[0]["kind"] == "source.fixAll");
  auto rewrites = actions(session, {{"diagnostics", Json::array()}, {"only", {"refactor"}}});
  REQUIRE(rewrites.size() == 1);
  CHECK(rewrites[0]["title"] == "Generate a monitor of `(lamp Off)`");
  CHECK(actions(session, {{"diagnostics", Json::array()}, {"only", {"refactor.inline"}}}).empty());
}

TEST_CASE("the edit of a code action, whatever stands before it in other characters") {
  Session session;
  session.initialize();
  session.open(kMain, kText);
  auto fix = actions(session, {{"diagnostics", Json::array()}, {"only", {"quickfix"}}})[0];
  Json edit =
      fix.contains("edit") ? fix["edit"] : session.result("codeAction/resolve", fix)["edit"];
  Json edits =
      edit.contains("changes") ? edit["changes"][kMain] : edit["documentChanges"][0]["edits"];
  CHECK(edits == Json::array({{{"range", test::rangeOf(1, 35, 37)}, {"newText", "Off"}}}));
}

TEST_CASE("the code of a diagnostic is explained, by the client or by the server") {
  Session session;
  session.initialize();
  session.open(kMain, kText);
  auto explain = actions(session, {{"diagnostics", Json::array()}, {"only", {"quickfix"}}})[1];
  CHECK(explain["title"] == "Explain PS0203");
  CHECK(!explain.contains("edit"));
  CHECK(session.result("codeAction/resolve", explain) == explain);
  const auto command = explain["command"];
  CHECK(command["command"] == "proskill.explain");
  CHECK(session.result("workspace/executeCommand", command) == nullptr);
  const std::string said = session.notified("window/showMessage")["message"];
  auto told = session.result("proskill/explain", {{"code", command["arguments"][0]}});
  CHECK(told["plain"] == said);
  CHECK(told["title"] == "`…` is not a value of `…`");
  CHECK(told["markdown"].get<std::string>().contains("```proskill\n"));
  CHECK(session.ask("proskill/explain", {{"code", "PS9999"}})["error"]["code"] == -32803);
  CHECK(session.ask("proskill/explain", Json::object())["error"]["code"] == -32602);
  CHECK(session.ask("workspace/executeCommand", {{"command", "x"}})["error"]["code"] == -32602);
}

TEST_CASE("an action is resolved in the text that it was offered for, and in no other") {
  Session session;
  session.initialize();
  session.open(kMain, kText);
  auto fix = actions(session, {{"diagnostics", Json::array()}, {"only", {"quickfix"}}})[0];
  fix.erase("edit");
  fix["data"] = {
      {"textDocument", {{"uri", kMain}}}, {"version", 1}, {"range", test::rangeOf(1, 37, 37)}};
  CHECK(session.result("codeAction/resolve", fix).contains("edit"));
  session.change(kMain, 2, test::rangeOf(0, 0, 0), " ");
  CHECK(session.ask("codeAction/resolve", fix)["error"]["code"] == -32801);
  CHECK(session.ask("codeAction/resolve", Json::object())["error"]["code"] == -32602);
}
