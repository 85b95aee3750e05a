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

namespace {

constexpr const char* kOther = "file:///w/other.proskill";

Json identified(const std::string& uri = kUri) { return {{"textDocument", {{"uri", uri}}}}; }

Json didOpen(int version, const std::string& text) {
  return {{"textDocument",
           {{"uri", kUri}, {"languageId", "proskill"}, {"version", version}, {"text", text}}}};
}

std::string wholeText(int version, const std::string& text) {
  return R"({"jsonrpc":"2.0","method":"textDocument/didChange","params":{"textDocument":{"uri":")" +
         std::string(kUri) + R"(","version":)" + std::to_string(version) +
         R"(},"contentChanges":[{"text":")" + text + "\"}]}}";
}

/// A session in which an edit of `; a` has sent half a character.
struct LostText {
  test::Session session;

  explicit LostText(const test::Session::Options& options = {}) : session(options) {
    session.initialize();
    session.notify("textDocument/didOpen", didOpen(1, "; a\n"));
    session.sendBody(edit(2, 2, 3, R"(\ud83d)"));
  }

  int errorOf(std::string_view method, const Json& params) {
    return session.ask(method, params)["error"]["code"].get<int>();
  }
  /// The name of the only symbol.
  std::string symbol() {
    const auto symbols = session.result("textDocument/documentSymbol", identified());
    REQUIRE(symbols.size() == 1);
    return symbols[0]["name"];
  }
  /// The diagnostics that are pushed next, if they are not those of the text as it was opened.
  Json pushed() {
    auto list = session.notified("textDocument/publishDiagnostics");
    return list.contains("version") && list["version"] == 1 ? pushed() : list["diagnostics"];
  }
};

const Json kDynamic{{"textDocument", {{"synchronization", {{"dynamicRegistration", true}}}}}};
constexpr int kContentModified = -32801;

} // namespace

TEST_CASE("an edit with half a character is an error, and its document is not served") {
  LostText text;
  CHECK(text.session.notified("window/showMessage") ==
        Json{{"type", 1},
             {"message", "an edit of `main.proskill` contains half a character; please close the "
                         "file and open it again"}});
  const auto found = text.pushed();
  REQUIRE(found.size() == 1);
  CHECK(found[0]["range"] == test::rangeOf(0, 0, 0));
  CHECK(
      found[0]["message"].get<std::string>().ends_with("please close the file and open it again"));
  CHECK(text.errorOf("textDocument/documentSymbol", identified()) == kContentModified);
  CHECK(text.errorOf("proskill/verify", identified()) == kContentModified);
  // it cannot be said where a part of an unknown text is
  text.session.sendBody(edit(3, 0, 3, "(defevent wrong)"));
  CHECK(text.errorOf("textDocument/documentSymbol", identified()) == kContentModified);
  CHECK_FALSE(text.session.wasNotified("window/showMessage"));
}

TEST_CASE("a document is served again when it is opened again") {
  LostText text;
  text.session.notify("textDocument/didClose", identified());
  text.session.notify("textDocument/didOpen", didOpen(3, "(defevent e)"));
  CHECK(text.symbol() == "e");
  CHECK(text.pushed().size() == 1);
  CHECK(text.pushed().empty());
}

TEST_CASE("a whole text makes a document known again, and edits of it fit") {
  LostText text;
  text.session.sendBody(wholeText(3, R"((defevent e) ; \ud83d\ude00)"));
  CHECK(text.symbol() == "e");
  text.session.sendBody(edit(4, 10, 11, "f"));
  CHECK(text.symbol() == "f");
  CHECK(text.pushed().size() == 1);
  CHECK(text.pushed().empty());
}

TEST_CASE("a client with dynamic registration is asked for whole texts, until all are known") {
  LostText text({.capabilities = kDynamic});
  const auto& session = text.session;
  auto registered = [&] {
    return text.session.notified("client/registerCapability")["registrations"][0];
  };
  CHECK(registered()["method"] == "textDocument/didOpen"); // of platform files
  const auto asked = registered();
  CHECK(asked["method"] == "textDocument/didChange");
  CHECK(asked["registerOptions"]["syncKind"] == 1);
  CHECK(text.session.notified("window/showMessage")["message"].get<std::string>().ends_with(
      "the editor is asked to send the whole text with the next edit"));
  // VS Code sends an edit by both registrations, the whole text first
  text.session.sendBody(wholeText(4, R"((defevent e) ; \ud83d\ude00)"));
  text.session.sendBody(edit(3, 3, 3, R"(\ude00)"));
  text.session.sendBody(edit(4, 0, 0, "; "));
  CHECK(text.symbol() == "e");
  text.session.sendBody(edit(5, 10, 11, "f"));
  CHECK(text.symbol() == "f");
  CHECK(text.session.notified("client/unregisterCapability")["unregisterations"][0]["id"] ==
        asked["id"]);
  CHECK_FALSE(session.wasNotified("client/registerCapability"));
}

TEST_CASE("edits that a whole text includes are not applied again with one that follows them") {
  test::Session session;
  session.initialize();
  session.notify("textDocument/didOpen", didOpen(1, ""));
  std::string bytes; // which the server reads at once
  for (const auto& body : {wholeText(3, "(defevent abc)"), edit(2, 10, 10, "b"),
                           edit(3, 11, 11, "c"), edit(4, 13, 13, "d")})
    bytes += rpc::frame(body);
  session.sendRaw(bytes);
  const auto symbols = session.result("textDocument/documentSymbol", identified());
  REQUIRE(symbols.size() == 1);
  CHECK(symbols[0]["name"] == "abcd");
}

TEST_CASE("whole texts are asked for while a text contains half a character") {
  test::Session session({.capabilities = kDynamic});
  session.initialize();
  session.notify("textDocument/didOpen", didOpen(1, "(defevent e) ;\n"));
  session.sendBody(wholeText(2, R"((defevent e) ; \ud83dx\ude00)"));
  CHECK(session.notified("window/logMessage") ==
        Json{{"type", 2},
             {"message", "`main.proskill` contains half a character, which is read as U+FFFD"}});
  CHECK(session.result("textDocument/documentSymbol", identified()).size() == 1);
  CHECK(session.wasNotified("client/registerCapability"));
  session.sendBody(wholeText(3, R"((defevent e) ; \ud83d\ude00)"));
  session.sendBody(edit(3, 16, 17, "")); // which makes the halves one character
  session.notified("client/unregisterCapability");
}

TEST_CASE("pulled diagnostics of a lost text say so, and nothing is renamed meanwhile") {
  LostText text({.pull = true});
  const auto report = text.session.result("textDocument/diagnostic", identified());
  CHECK(report["kind"] == "full");
  CHECK(report["items"].size() == 1);
  text.session.open(kOther, "(defevent e)");
  Json rename = identified(kOther);
  rename["position"] = {{"line", 0}, {"character", 10}};
  rename["newName"] = "f";
  CHECK(text.errorOf("textDocument/rename", rename) == kContentModified);
  text.session.sendBody(wholeText(3, ""));
  CHECK(text.session.result("textDocument/rename", rename)["documentChanges"].size() == 1);
}

TEST_CASE("a message that cannot be read is answered with an error, and the user is told") {
  test::Session session;
  session.initialize();
  session.sendBody("{\"jsonrpc\":\"2.0\",\"method\":\"textDocument/didChange\",\"params\":{");
  CHECK(session.notified("window/showMessage")["type"] == 1);
}

} // namespace proskill::test::odd_messages_test
