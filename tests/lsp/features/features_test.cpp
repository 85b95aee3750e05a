#include "tests/lsp/support/session.h"

#include <catch2/catch.hpp>

namespace proskill::test::features_test {

using test::rangeOf;
using test::Session;

/// Features over the wire: positions are counted as the client counts, and each answer has the
/// protocol's form. tests/ide covers the contents.
namespace {

constexpr auto kMain = "file:///w/main.proskill";
constexpr auto kLib = "file:///w/lib.proskill";

/// The robots are beyond the BMP: four bytes, two units of UTF-16, one character each.
const std::string kText = "(defsv lamp :states (On Off) :init Off)\n"
                          "(defskill go :input ($x int) :success done :action (go $x))\n"
                          "(defskill m :body ((printf \"🤖🤖\") (go x 1) (set (lamp On))))\n";

/// The column of the `nth` byte of the third line, which is after the robots.
unsigned column(std::string_view encoding, unsigned byte) {
  return byte - (encoding == "utf-8" ? 0 : encoding == "utf-16" ? 4 : 6);
}
constexpr unsigned kGo = 40; ///< in bytes: the call of `go` in the third line

Json open(Session& session) {
  session.initialize();
  session.open(kMain, kText);
  return {{"uri", kMain}};
}

} // namespace

TEST_CASE("places behind characters beyond the BMP, in the encoding of the client") {
  for (const std::string encoding : {"utf-8", "utf-16", "utf-32"}) {
    INFO(encoding);
    Session session({.encoding = encoding});
    open(session);
    const auto go = column(encoding, kGo);
    const auto call = rangeOf(2, go, go + 2);

    auto hover = session.at("textDocument/hover", kMain, 2, go + 1);
    CHECK(hover["range"] == call);
    CHECK(hover["contents"]["kind"] == "markdown");

    CHECK(session.at("textDocument/prepareRename", kMain, 2, go)["range"] == call);
    auto rename = session.at("textDocument/rename", kMain, 2, go, {{"newName", "drive"}});
    const auto& edits = rename["documentChanges"][0]["edits"];
    REQUIRE(edits.size() == 2);
    CHECK(edits[1] == Json{{"range", call}, {"newText", "drive"}});

    auto item = session.at("textDocument/prepareCallHierarchy", kMain, 2, go)[0];
    auto incoming = session.result("callHierarchy/incomingCalls", {{"item", item}});
    REQUIRE(incoming.size() == 1);
    CHECK(incoming[0]["from"]["name"] == "m");
    CHECK(incoming[0]["fromRanges"] == Json::array({call}));

    auto hints = session.result("textDocument/inlayHint", {{"textDocument", {{"uri", kMain}}},
                                                           {"range", rangeOf(2, go, go + 9)}});
    REQUIRE(hints.size() == 1);
    CHECK(hints[0]["label"][0]["value"] == ": int");
    CHECK(hints[0]["position"] == Json{{"line", 2}, {"character", go + 4}});

    auto lamp = column(encoding, 54);
    auto values =
        session.result("textDocument/inlineValue",
                       {{"textDocument", {{"uri", kMain}}},
                        {"range", rangeOf(2, 0, 90)},
                        {"context", {{"frameId", 1}, {"stoppedLocation", rangeOf(2, 0, 90)}}}});
    REQUIRE(values.size() == 1);
    CHECK(values[0]["range"] == rangeOf(2, lamp, lamp + 4));
    CHECK(values[0]["variableName"] == "lamp");
  }
}

TEST_CASE("a renaming carries the versions of the texts, and is refused with a reason") {
  Session session;
  open(session);
  session.open(kLib, "(include \"main.proskill\")\n(defevent e :effects (lamp On))\n", 7);
  auto rename = session.at("textDocument/rename", kMain, 0, 8, {{"newName", "light"}});
  REQUIRE(rename["documentChanges"].size() == 2);
  CHECK(rename["documentChanges"][0]["textDocument"] == Json{{"uri", kLib}, {"version", 7}});
  CHECK(rename["documentChanges"][1]["textDocument"] == Json{{"uri", kMain}, {"version", 1}});

  const Json params{{"textDocument", {{"uri", kMain}}},
                    {"position", {{"line", 0}, {"character", 8}}},
                    {"newName", "3d"}};
  auto refused = session.ask("textDocument/rename", params);
  CHECK(refused["error"]["code"] == -32803);
  CHECK(refused["error"]["message"].get<std::string>().contains("is not a name"));
  Json nowhere = params;
  nowhere["position"]["character"] = 2;
  CHECK(session.ask("textDocument/prepareRename", nowhere)["error"]["code"] == -32803);
  nowhere.erase("newName");
  CHECK(session.ask("textDocument/rename", nowhere)["error"]["code"] == -32602);
}

TEST_CASE("the outline as a tree, and symbols of the workspace") {
  Session session;
  const auto document = open(session);
  auto tree = session.result("textDocument/documentSymbol", {{"textDocument", document}});
  REQUIRE(tree.size() == 3);
  CHECK(tree[0]["name"] == "lamp");
  CHECK(tree[0]["selectionRange"] == rangeOf(0, 7, 11));
  CHECK(tree[0]["children"].size() == 2);
  auto found = session.result("workspace/symbol", {{"query", "lmp"}});
  REQUIRE(found.size() == 1);
  CHECK(found[0]["location"] == Json{{"uri", kMain}, {"range", rangeOf(0, 7, 11)}});
  CHECK(session.ask("workspace/symbol", Json::object())["error"]["code"] == -32602);
}

TEST_CASE("a signature names the part that is being written") {
  Session session({.encoding = "utf-8"});
  open(session);
  auto help = session.at("textDocument/signatureHelp", kMain, 2, kGo + 5);
  CHECK(help["activeParameter"] == 0);
  CHECK(help["signatures"][0]["label"] == "(go x int)");
  CHECK(help["signatures"][0]["parameters"][0]["label"] == "x int");
  CHECK(session.at("textDocument/signatureHelp", kMain, 3, 0) == nullptr);
}

TEST_CASE("hierarchies ask for more with an item, whose file may have changed meanwhile") {
  Session session;
  open(session);
  auto lamp = session.at("textDocument/prepareTypeHierarchy", kMain, 0, 8)[0];
  auto users = session.result("typeHierarchy/subtypes", {{"item", lamp}});
  REQUIRE(users.size() == 1);
  CHECK(users[0]["name"] == "m");
  CHECK(session.result("typeHierarchy/supertypes", {{"item", lamp}}).empty());
  auto variables = session.result("typeHierarchy/supertypes", {{"item", users[0]}});
  REQUIRE(variables.size() == 1);
  CHECK(variables[0]["name"] == "lamp");
  session.change(kMain, 2, nullptr, "(defskill m :body ((^ 1)))\n");
  CHECK(session.result("typeHierarchy/subtypes", {{"item", lamp}}) == nullptr);
  CHECK(session.result("callHierarchy/outgoingCalls", {{"item", Json::object()}}) == nullptr);
}

TEST_CASE("lenses count references when they are looked at") {
  Session session;
  const auto document = open(session);
  auto lenses = session.result("textDocument/codeLens", {{"textDocument", document}});
  REQUIRE(lenses.size() == 8);
  CHECK_FALSE(lenses[0].contains("command"));
  auto references = session.result("codeLens/resolve", lenses[0]);
  CHECK(references["command"]["title"] == "1 reference");
  CHECK(references["command"]["command"] == "proskill.showReferences");
  CHECK(references["command"]["arguments"][0] == kMain);
  CHECK(references["command"]["arguments"][1] == Json{{"line", 0}, {"character", 7}});
  CHECK(references["command"]["arguments"][2].size() == 1);
  CHECK(lenses[1]["command"]["command"] == "proskill.showAutomaton");
  CHECK(lenses[1]["command"]["arguments"][0] ==
        Json{{"textDocument", document}, {"kind", "sv"}, {"name", "lamp"}});
  CHECK(lenses[4]["command"]["command"] == "proskill.verify");
  CHECK(lenses[4]["command"]["arguments"][0] ==
        Json{{"textDocument", document}, {"names", Json::array({"go"})}});
}

TEST_CASE("tags and labels are edited together") {
  Session session;
  open(session);
  auto linked = session.at("textDocument/linkedEditingRange", kMain, 1, 40);
  CHECK(linked["ranges"] == Json::array({rangeOf(1, 38, 42)}));
  CHECK(session.at("textDocument/linkedEditingRange", kMain, 1, 11) == nullptr);
}

} // namespace proskill::test::features_test
