#include "tests/lsp/support/session.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace proskill::test::completion_test {

using test::rangeOf;
using test::Session;

namespace {

constexpr auto kMain = "file:///w/main.proskill";

/// The name of the robot in the comment is beyond the BMP: one character, two units of UTF-16.
const std::string kText = "(defsv lamp :states (On Off) :init Off) ; Lights.\n"
                          "(defskill go :input ($x int) :action (go $x))\n"
                          "(defskill m :body ((printf \"🤖🤖\") (g)))\n"
                          "(defevent e :effects (lamp ))\n";

Json itemOf(const Json& answer, const std::string& label) {
  for (const auto& item : answer["items"])
    if (item["label"] == label) return item;
  FAIL("no " << label << " in " << answer.dump());
  return {};
}

} // namespace

TEST_CASE("a completion replaces what is typed, counted in the encoding of the client") {
  // the columns after the two robots: 8 bytes, 4 units of UTF-16, 2 characters
  for (auto [encoding, column] :
       {std::pair{"utf-8", 41U}, std::pair{"utf-16", 37U}, std::pair{"utf-32", 35U}}) {
    Session session({.encoding = encoding});
    session.initialize();
    session.open(kMain, kText);
    auto answer = session.at("textDocument/completion", kMain, 2, column);
    CHECK(answer["isIncomplete"] == false);
    auto item = itemOf(answer, "go");
    CHECK(item["textEdit"]["range"] == rangeOf(2, column - 1, column));
    CHECK(item["textEdit"]["newText"] == "go x ${1:0}");
    CHECK(item["insertTextFormat"] == 2);
  }
}

TEST_CASE("the lines of a snippet are indented by the server") {
  for (const bool supported : {true, false}) {
    Session::Options options;
    if (supported)
      options.capabilities["textDocument"]["completion"]["completionItem"]
                          ["insertTextModeSupport"] = {{"valueSet", {1, 2}}};
    Session session(options);
    session.initialize();
    session.open(kMain, "(defsk)\n");
    const auto answer = session.at("textDocument/completion", kMain, 0, 6);
    const auto item = itemOf(answer, "defskill");
    CHECK(item["textEdit"]["newText"] == "defskill ${1:name}\n  $0");
    CHECK(item.value("insertTextMode", 0) == (supported ? 1 : 0));
    CHECK_FALSE(itemOf(answer, "include").contains("insertTextMode"));
  }
}

TEST_CASE("a snippet within a body is indented from its own parenthesis") {
  Session::Options options;
  options.capabilities["textDocument"]["completion"]["completionItem"]["insertTextModeSupport"] = {
      {"valueSet", {1, 2}}};
  Session session(options);
  session.initialize();
  session.open(kMain, "(defskill m\n  :body\n    ((wh)\n     w))\n");
  const auto inList = session.at("textDocument/completion", kMain, 2, 8);
  CHECK(itemOf(inList, "while")["textEdit"]["newText"] == "while ($1)\n       $0");
  const auto asList = session.at("textDocument/completion", kMain, 3, 6);
  CHECK(itemOf(asList, "while")["textEdit"]["newText"] == "(while ($1)\n       $0)");
}

TEST_CASE("what is deprecated is struck out where it is offered and where it is used") {
  Session session;
  session.initialize();
  session.open(kMain, "; Deprecated: use go.\n(defskill run :action (run))\n"
                      "(defskill go :action (go))\n(defskill m :body ((run) ()))\n");
  const auto answer = session.at("textDocument/completion", kMain, 3, 25);
  CHECK(itemOf(answer, "run")["tags"] == Json::array({1}));
  CHECK_FALSE(itemOf(answer, "go").contains("tags"));
  const auto told = session.notified("textDocument/publishDiagnostics")["diagnostics"];
  const auto found =
      std::ranges::find(told, "PS0230", [](const Json& each) { return each["code"]; });
  REQUIRE(found != told.end());
  CHECK((*found)["tags"] == Json::array({2}));
}

TEST_CASE("values are ranked in the order of their definition, and told when looked at") {
  Session session;
  session.initialize();
  session.open(kMain, kText);
  auto answer = session.at("textDocument/completion", kMain, 3, 27,
                           {{"context", {{"triggerKind", 2}, {"triggerCharacter", " "}}}});
  REQUIRE(answer["items"].size() == 2);
  CHECK(answer["items"][0]["label"] == "On");
  CHECK(answer["items"][0]["sortText"] < answer["items"][1]["sortText"]);
  auto resolved = session.result("completionItem/resolve", answer["items"][0]);
  CHECK(resolved["documentation"]["value"].get<std::string>().contains("A value of lamp."));
  CHECK(resolved["label"] == "On");
}

TEST_CASE("an item that means nothing any more is given back as it is") {
  Session session;
  session.initialize();
  session.open(kMain, kText);
  for (const Json& data :
       {Json(nullptr), Json(3), Json{{"uri", kMain}}, Json{{"uri", "file:///w/other"}},
        Json{{"uri", kMain}, {"word", 100000}},
        Json{{"uri", kMain}, {"symbol", {{"kind", 99}, {"name", "x"}, {"owner", ""}}}},
        Json{{"uri", kMain}, {"symbol", {{"kind", 2}, {"name", "nobody"}, {"owner", ""}}}}}) {
    const Json item{{"label", "x"}, {"data", data}};
    CHECK(session.result("completionItem/resolve", item) == item);
  }
}

} // namespace proskill::test::completion_test
