#include "lsp/features/feature_fiacre.h"
#include "tests/lsp/support/byte_places.h"
#include "tests/lsp/support/desk.h"
#include "tests/lsp/support/examples.h"
#include "tests/lsp/support/session.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::Encoding;
using test::Desk;
using test::Session;

namespace {

constexpr auto kUri = "file:///w/m.fcr";
constexpr auto kModel = "process P is\nstates a, b\n\nfrom a\n    to b\n\nfrom b\n    to a\n\n"
                        "component m is\npar\n    P\nend\n\nm\n";

std::map<std::string, std::string> models() {
  std::map<std::string, std::string> result;
  for (const auto& entry :
       std::filesystem::directory_iterator(PROSKILL_SOURCE_DIR "/examples/fiacre"))
    if (entry.path().extension() == ".fcr")
      result[entry.path().filename().string()] = test::contents(entry.path());
  return result;
}

/// Every method, at every place; throws if an answer is invalid.
std::size_t askAll(const Desk& desk, const std::string& file, std::size_t stride) {
  std::size_t answered = 0;
  const auto places = test::placesIn(desk.text(file), false);
  for (const auto& method : desk.methodsOfPlaces())
    for (std::size_t i = 0; i < places.size(); i += stride) {
      INFO(file << ", byte " << places[i] << ": " << method);
      Json answer;
      CHECK_NOTHROW(answer = desk.ask(method, file, places[i]));
      answered += !answer.empty() && !answer.contains("error");
    }
  for (const auto& method : desk.methodsOfDocuments()) {
    INFO(file << ": " << method);
    CHECK_NOTHROW(desk.ask(method, file, 0));
  }
  return answered;
}

} // namespace

TEST_CASE("every feature is asked at every place of the examples of Fiacre") {
  const Desk desk(models(), Encoding::Utf16);
  for (const auto& [file, text] : models()) CHECK(askAll(desk, file, 3) > 100);
}

TEST_CASE("it is decided for each method what it does for models in Fiacre") {
  for (const auto& [method, entry] : lsp::allFeatures().methods) {
    INFO(method);
    CHECK(lsp::isDecidedForFiacre(method));
  }
  CHECK_FALSE(lsp::isDecidedForFiacre("textDocument/somethingNew"));
}

TEST_CASE("every feature is asked while a model is typed") {
  for (const auto& [file, text] : models())
    for (std::size_t length = 0; length < text.size(); length += 211)
      askAll(Desk({{file, text.substr(0, length)}}, Encoding::Utf8), file, 17);
}

TEST_CASE("what is wrong with a model is told, and nothing of programs") {
  Session session;
  session.initialize();
  session.open(kUri, "process P is\nstates a\nfrom a to c\ncomponent m is par P end\nm\n");
  const auto told = session.notified("textDocument/publishDiagnostics")["diagnostics"];
  REQUIRE(told.size() == 1);
  CHECK(told[0]["message"] == "process P, state a: the state `c` is not declared");
  CHECK(told[0]["range"] == test::rangeOf(2, 10, 11));
  const auto document = Json{{"textDocument", {{"uri", kUri}}}};
  const auto lenses = session.result("textDocument/codeLens", document);
  REQUIRE(lenses.size() == 1);
  CHECK(lenses[0]["command"]["title"] == "verify");
  CHECK(session.ask("proskill/model", document)["error"]["message"].get<std::string>().find(
            "not supported for Fiacre") != std::string::npos);
}

TEST_CASE("of several `from` of one state the second is told, with the edit that joins them") {
  Session session;
  session.initialize();
  session.open(kUri,
               "process P is\nstates a\nfrom a\n    to a\nfrom a\n    wait [1,1];\n    to a\nP\n");
  const auto told = session.notified("textDocument/publishDiagnostics")["diagnostics"];
  REQUIRE(told.size() == 1);
  CHECK(told[0]["range"] == test::rangeOf(4, 5, 6));
  const auto actions =
      session.result("textDocument/codeAction", {{"textDocument", {{"uri", kUri}}},
                                                 {"range", test::rangeOf(4, 5, 6)},
                                                 {"context", {{"diagnostics", Json::array()}}}});
  REQUIRE(actions.size() == 1);
  const auto edit = actions[0]["edit"]["changes"][kUri][0];
  CHECK(edit["newText"] == "select\n        to a\n    []  wait [1,1];\n    to a\n    end\n");
}

TEST_CASE("a model has definitions, references, an outline and a layout in editors") {
  Session session;
  session.initialize();
  session.open(kUri, kModel);
  const auto definition = session.at("textDocument/definition", kUri, 4, 8);
  REQUIRE(definition.size() == 1);
  CHECK(definition[0]["range"] == test::rangeOf(1, 10, 11));
  CHECK(
      session
          .at("textDocument/references", kUri, 4, 7, {{"context", {{"includeDeclaration", true}}}})
          .size() == 3);
  const auto highlights = session.at("textDocument/documentHighlight", kUri, 1, 7);
  REQUIRE(highlights.size() == 3);
  CHECK(highlights[0]["kind"] == 3);
  CHECK(highlights[1]["kind"] == 2);
  const auto document = Json{{"textDocument", {{"uri", kUri}}}};
  CHECK(session.result("textDocument/documentSymbol", document).size() == 2);
  auto laidOut = document;
  laidOut["options"] = {{"tabSize", 2}, {"insertSpaces", true}};
  CHECK(session.result("textDocument/formatting", laidOut) == Json::array());
  session.change(kUri, 2, test::rangeOf(4, 0, 4), " ");
  CHECK(session.result("textDocument/formatting", laidOut).size() == 1);
  CHECK(session.result("textDocument/semanticTokens/full", document)["data"].size() % 5 == 0);
  CHECK_FALSE(session.result("textDocument/foldingRange", document).empty());
}

TEST_CASE("a name of a model is renamed wherever it means the same, and nothing else is") {
  Session session;
  session.initialize();
  session.open(kUri, kModel);
  const auto name = session.at("textDocument/prepareRename", kUri, 4, 7);
  CHECK(name["placeholder"] == "b");
  CHECK(name["range"] == test::rangeOf(4, 7, 8));
  const auto made = session.at("textDocument/rename", kUri, 4, 7, {{"newName", "c"}});
  const auto& edits =
      made.contains("changes") ? made["changes"][kUri] : made["documentChanges"][0]["edits"];
  REQUIRE(edits.size() == 3);
  CHECK(edits[0]["range"] == test::rangeOf(1, 10, 11));
  CHECK(edits[2]["range"] == test::rangeOf(6, 5, 6));
  CHECK(edits[2]["newText"] == "c");
}
