#include "tests/lsp/support/session.h"

#include <catch2/catch.hpp>

namespace proskill::test::formatting_test {

using test::Session;

namespace {

constexpr auto kMain = "file:///w/main.proskill";

Json params(Json more = Json::object()) {
  more["textDocument"] = {{"uri", kMain}};
  more["options"] = {{"tabSize", 8}, {"insertSpaces", false}};
  return more;
}

Json edit(unsigned line, unsigned from, unsigned to, const char* text) {
  return {{"range", test::rangeOf(line, from, to)}, {"newText", text}};
}

} // namespace

TEST_CASE("formatting counts columns as the client does") {
  for (const auto& [encoding, column] :
       {std::pair("utf-8", 19U), std::pair("utf-16", 17U), std::pair("utf-32", 16U)}) {
    Session session({.encoding = encoding});
    session.initialize();
    session.open(kMain,
                 "(defskill m\n  :body\n    ((printf \"\U0001f600\"   1)))\n(defevent  f)\n");
    INFO(encoding);
    CHECK(session.result("textDocument/formatting", params()) ==
          Json::array({edit(2, column + 1, column + 3, ""), edit(3, 10, 11, "")}));
  }
}

TEST_CASE("formatting of lines, and of what is typed") {
  Session session;
  session.initialize();
  session.open(kMain, "(defevent  e)\n(defevent  f)\n(defevent  g\n)\n");
  CHECK(
      session.result("textDocument/rangeFormatting", params({{"range", test::rangeOf(1, 0, 3)}})) ==
      Json::array({edit(1, 10, 11, "")}));
  CHECK(session.result("textDocument/rangesFormatting",
                       params({{"ranges", {test::rangeOf(0, 0, 3), test::rangeOf(1, 0, 3)}}})) ==
        Json::array({edit(0, 10, 11, ""), edit(1, 10, 11, "")}));
  CHECK(session.at("textDocument/onTypeFormatting", kMain, 3, 0,
                   {{"ch", "\n"}, {"options", {{"tabSize", 8}, {"insertSpaces", false}}}}) ==
        Json::array({edit(3, 0, 0, "  ")}));
  CHECK(session.answer(session.send("textDocument/rangeFormatting", params()))["error"]["code"] ==
        -32602);
}

TEST_CASE("lines that were typed are indented on request") {
  Session session;
  session.initialize();
  session.open(kMain, "(defskill m\n:body\n((f)\n(g)\n");
  CHECK(session.result("proskill/indent", params({{"lines", {3, 1, 2, 2}}})) ==
        Json::array({edit(1, 0, 0, "  "), edit(2, 0, 0, "    "), edit(3, 0, 0, "     ")}));
  CHECK(session.result("proskill/indent", params({{"lines", {70}}})) == Json::array());
  for (const auto& lines : {Json(), Json("1"), Json::array({-1}), Json::array({"1"})})
    CHECK(session.ask("proskill/indent", params({{"lines", lines}}))["error"]["code"] == -32602);
}

} // namespace proskill::test::formatting_test
