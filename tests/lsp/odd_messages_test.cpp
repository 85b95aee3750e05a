#include "tests/lsp/support/session.h"

#include <catch2/catch.hpp>

namespace proskill::test::odd_messages_test {

using rpc::parseMessage;

namespace {

std::string textIn(const std::string& json) {
  const auto message =
      parseMessage(R"({"jsonrpc":"2.0","method":"m","params":{"text":")" + json + "\"}}");
  REQUIRE(message);
  return message->params["text"];
}

constexpr const char* kUri = "file:///w/main.proskill";

std::string edit(int version, unsigned from, unsigned to, const std::string& text) {
  return R"({"jsonrpc":"2.0","method":"textDocument/didChange","params":{"textDocument":{"uri":")" +
         std::string(kUri) + R"(","version":)" + std::to_string(version) +
         R"(},"contentChanges":[{"range":{"start":{"line":0,"character":)" + std::to_string(from) +
         R"(},"end":{"line":0,"character":)" + std::to_string(to) + R"(}},"text":")" + text +
         "\"}]}}";
}

} // namespace

TEST_CASE("half a character in a message reads as U+FFFD, and all else as it was sent") {
  CHECK(textIn(R"(a\ud83db)") == "a\uFFFDb");
  CHECK(textIn(R"(a\ude00b)") == "a\uFFFDb");
  CHECK(textIn(R"(\ude00\ud83d)") == "\uFFFD\uFFFD");
  CHECK(textIn(R"(\ud83d\ud83d\ude00)") == "\uFFFD😀");
  CHECK(textIn(R"(\\ud83d\ud83d)") == "\\ud83d\uFFFD");
  CHECK(textIn("\xff\xc3(\\n") == "\uFFFD\uFFFD(\n");
  CHECK(textIn(R"(\ud83d\ude00)") == "😀");
  CHECK_FALSE(parseMessage(R"({"jsonrpc":"2.0","method":"\ud83d)"));
  CHECK_FALSE(parseMessage("\\"));
}

TEST_CASE(
    "an edit with half a character is applied, said, and followed by others at their places") {
  test::Session session;
  session.initialize();
  session.notify(
      "textDocument/didOpen",
      {{"textDocument",
        {{"uri", kUri}, {"languageId", "proskill"}, {"version", 1}, {"text", "; a\n"}}}});
  session.sendBody(edit(2, 2, 3, R"(\ud83d)"));
  session.sendBody(edit(3, 3, 3, " b"));
  CHECK(session.notified("window/logMessage")["message"] ==
        "the editor sent half a character, which is read as U+FFFD");
  session.sendBody(edit(4, 0, 5, "(defevent e)"));
  const auto symbols =
      session.result("textDocument/documentSymbol", {{"textDocument", {{"uri", kUri}}}});
  REQUIRE(symbols.size() == 1);
  CHECK(symbols[0]["name"] == "e");
}

TEST_CASE("a message that cannot be read is answered with an error, and the user is told") {
  test::Session session;
  session.initialize();
  session.sendBody("{\"jsonrpc\":\"2.0\",\"method\":\"textDocument/didChange\",\"params\":{");
  CHECK(session.notified("window/showMessage")["type"] == 1);
}

} // namespace proskill::test::odd_messages_test
