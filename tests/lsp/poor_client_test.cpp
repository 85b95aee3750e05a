#include "lsp/protocol/registry.h"
#include "rpc/json_writer.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

namespace proskill::test::poor_client_test {

using lsp::ClientFeatures;

/// What clients get that support less, or more, than the one of the sessions.
namespace {

constexpr auto kUri = "file:///w/main.proskill";
const std::string kText = "; Goes.\n(defskill go :input ($x int) :action (go $x))\n"
                          "(defskill m :body ((go )))\n"
                          "(defproperty p (leadsto true ))\n";

Json ask(const ClientFeatures& client, const std::string& method, Json params) {
  ide::OpenTexts texts;
  texts["/w/main.proskill"] = {kUri, 1, syntax::Document::parse(kText)};
  const auto disk = std::make_shared<test::MemoryFiles>();
  const ide::Snapshot snapshot(disk, texts, ide::graphOf(*disk, texts));
  params["textDocument"] = {{"uri", kUri}};
  const lsp::Registry registry = lsp::allFeatures();
  const lsp::Request request{
      .params = params, .snapshot = snapshot, .client = client, .cancellation = {}};
  auto answer = registry.methods.at(method).handler(request);
  REQUIRE(answer);
  return Json::parse(rpc::dump(*answer));
}

Json at(unsigned line, unsigned character) {
  return {{"position", {{"line", line}, {"character", character}}}};
}

Json itemOf(const Json& answer, const std::string& label) {
  for (const auto& item : answer["items"])
    if (item["label"] == label) return item;
  FAIL("no " << label);
  return {};
}

} // namespace

TEST_CASE("completions are plain text where the client has no snippets") {
  auto item = itemOf(ask({}, "textDocument/completion", at(2, 20)), "go");
  CHECK(item["textEdit"]["newText"] == "go");
  CHECK_FALSE(item.contains("insertTextFormat"));
}

TEST_CASE("completions say what to insert and to replace where the client can choose") {
  ClientFeatures client;
  client.insertReplace = true;
  const auto edit = itemOf(ask(client, "textDocument/completion", at(2, 21)), "go")["textEdit"];
  auto range = [](unsigned from, unsigned to) -> Json {
    return {{"start", {{"line", 2}, {"character", from}}},
            {"end", {{"line", 2}, {"character", to}}}};
  };
  CHECK(edit["insert"] == range(20, 21));
  CHECK(edit["replace"] == range(20, 22));
}

TEST_CASE("hovers are plain text where the client shows no markdown") {
  const auto contents = ask({}, "textDocument/hover", at(1, 11))["contents"];
  CHECK(contents["kind"] == "plaintext");
  CHECK_FALSE(contents["value"].get<std::string>().contains('`'));
}

TEST_CASE("an outline is flat where the client knows no trees") {
  const auto symbols = ask({}, "textDocument/documentSymbol", Json::object());
  REQUIRE(symbols.size() == 4);
  CHECK(symbols[1]["name"] == "x");
  CHECK(symbols[1]["containerName"] == "go");
  CHECK(symbols[1]["location"]["uri"] == kUri);
}

TEST_CASE("a renaming has no versions where the client knows none") {
  auto params = at(1, 11);
  params["newName"] = "drive";
  const auto edit = ask({}, "textDocument/rename", params);
  CHECK_FALSE(edit.contains("documentChanges"));
  CHECK(edit["changes"][kUri].size() == 2);
}

TEST_CASE("parts of a signature as offsets, which are those of UTF-16") {
  ClientFeatures client;
  client.labelOffsets = true;
  auto signature = ask(client, "textDocument/signatureHelp", at(3, 29))["signatures"][0];
  CHECK(signature["label"] == "(leadsto P Q [:within I])");
  CHECK(signature["activeParameter"] == 1);
  CHECK(signature["parameters"][1]["label"] == Json::array({11, 12}));
  // `…` is three bytes and one unit: columns after it are correct
  signature = ask(client, "textDocument/signatureHelp", at(2, 19))["signatures"][0];
  const auto label = signature["label"].get<std::string>();
  CHECK(label.contains("…"));
  CHECK(signature["parameters"][0]["label"] == Json::array({0, label.size() - 2}));
}

} // namespace proskill::test::poor_client_test
