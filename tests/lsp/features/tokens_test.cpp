#include "tests/lsp/support/session.h"
#include "tests/lsp/support/token_edits.h"

#include <catch2/catch.hpp>

namespace proskill::test::tokens_test {

using test::Session;

namespace {

constexpr auto kMain = "file:///w/main.proskill";
const Json kText{{"textDocument", {{"uri", kMain}}}};

Json changed(Session& session, const Json& before) {
  Json params = kText;
  params["previousResultId"] = before["resultId"];
  return session.result("textDocument/semanticTokens/full/delta", params);
}

} // namespace

TEST_CASE("tokens count columns as the client does") {
  for (const auto& [encoding, length] :
       {std::pair("utf-8", 8), std::pair("utf-16", 5), std::pair("utf-32", 4)}) {
    Session session({.encoding = encoding});
    session.initialize();
    session.open(kMain, "\n; \U0001f600\u00e9\n(defevent e)\n");
    auto data = session.result("textDocument/semanticTokens/full", kText)["data"];
    INFO(encoding);
    CHECK(data.size() == 15);
    CHECK(data[0] == 1);
    CHECK(data[1] == 0);
    CHECK(data[2] == length);
  }
}

TEST_CASE("changes of tokens give the tokens of the whole") {
  Session session;
  session.initialize();
  session.open(kMain, "(defsv a :init 1 :max 2)\n(defevent e :effects (a 1))\n(defevent f)\n");
  auto before = session.result("textDocument/semanticTokens/full", kText);
  auto none = changed(session, before);
  CHECK(none["edits"].empty());
  auto data = before["data"];
  auto last = none;
  int version = 1;
  for (const auto& [range, text] :
       {std::pair(test::rangeOf(1, 22, 23), "nobody"), std::pair(test::rangeOf(0, 0, 0), "\n; x\n"),
        std::pair(test::rangeOf(2, 0, 24), ""), std::pair(test::rangeOf(3, 0, 5), "")}) {
    session.change(kMain, ++version, range, text);
    last = changed(session, last);
    data = test::afterEdits(data, last["edits"]);
    CHECK(data == session.result("textDocument/semanticTokens/full", kText)["data"]);
    last = session.result("textDocument/semanticTokens/full", kText);
  }
}

TEST_CASE("changes since an answer that is not known are all tokens") {
  Session session;
  session.initialize();
  session.open(kMain, "(defevent e)\n");
  CHECK(changed(session, {{"resultId", "nobody's"}})["data"].size() == 10);
  CHECK(session.ask("textDocument/semanticTokens/full/delta", kText)["error"]["code"] == -32602);
}

TEST_CASE("tokens of a range") {
  Session session;
  session.initialize();
  session.open(kMain, "(defevent e)\n(defevent f)\n");
  Json params = kText;
  params["range"] = test::rangeOf(1, 0, 4);
  auto data = session.result("textDocument/semanticTokens/range", params)["data"];
  CHECK(data == Json::array({1, 1, 8, 0, 0}));
}

TEST_CASE("folds, selections and links of a session") {
  Session session;
  session.initialize();
  session.open(kMain, "; \U0001f600\n; b\n(include \"a.proskill\") (defevent e)\n");
  CHECK(session.result("textDocument/foldingRange", kText) ==
        Json::array({{{"startLine", 0}, {"endLine", 1}, {"kind", "comment"}}}));
  auto links = session.result("textDocument/documentLink", kText);
  CHECK(links[0]["target"] == "file:///w/a.proskill");
  CHECK(links[0]["range"] == test::rangeOf(2, 10, 20));
  Json params = kText;
  params["positions"] = {{{"line", 2}, {"character", 33}}, {{"line", 0}, {"character", 4}}};
  auto selections = session.result("textDocument/selectionRange", params);
  CHECK(selections[0]["range"] == test::rangeOf(2, 33, 34));
  CHECK(selections[0]["parent"]["range"] == test::rangeOf(2, 24, 34));
  CHECK(selections[1]["range"] == test::rangeOf(0, 0, 4));
}

} // namespace proskill::test::tokens_test
