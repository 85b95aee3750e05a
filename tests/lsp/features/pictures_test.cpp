#include "tests/lsp/support/session.h"

#include <catch2/catch.hpp>

namespace proskill::test::pictures_test {

using test::rangeOf;
using test::Session;

namespace {

constexpr auto kUri = "file:///w/main.proskill";

const std::string kText = "; 😀\n"
                          "(defsv lamp :states (On Off) :init Off :transitions :all)\n"
                          "(defskill switch_on :action (a) :success on (:effects (lamp On)))\n"
                          "(defskill mission :body ((switch_on) (switch_on)))\n";

Json asking(const Json& more) {
  Json params = {{"textDocument", {{"uri", kUri}}}};
  params.update(more);
  return params;
}

Json partOf(const Json& parts, const std::string& id) {
  for (const auto& part : parts)
    if (part["id"] == id) return part;
  return nullptr;
}

} // namespace

TEST_CASE("a picture's parts have the identifiers of the SVG, and places in the text") {
  Session session;
  session.initialize();
  session.open(kUri, kText);
  auto picture = session.result("proskill/automaton", asking({{"kind", "sv"}, {"name", "lamp"}}));
  CHECK(picture["kind"] == "sv");
  CHECK(picture["errors"] == false);
  CHECK(picture["texts"] == Json::array({{{"uri", kUri}, {"version", 1}}}));
  const auto svg = picture["content"].get<std::string>();
  REQUIRE(picture["nodes"].size() >= 2);
  for (const auto& node : picture["nodes"])
    CHECK(svg.find("<g id=\"" + node["id"].get<std::string>() + "\"") != std::string::npos);
  for (const auto& edge : picture["edges"]) {
    CHECK(svg.find("<g id=\"" + edge["id"].get<std::string>() + "\"") != std::string::npos);
    CHECK_FALSE(partOf(picture["nodes"], edge["from"]).is_null());
  }
  Json off;
  for (const auto& node : picture["nodes"])
    if (node["label"] == "Off") off = node;
  CHECK(off["location"] == Json({{"uri", kUri}, {"range", rangeOf(1, 24, 27)}}));
  CHECK(session.result("proskill/automaton",
                       asking({{"kind", "sv"}, {"name", "lamp"}}))["content"] == svg);
}

TEST_CASE("the picture at a place, and which part of it the place is") {
  Session session;
  session.initialize();
  session.open(kUri, kText);
  auto at = [&](unsigned line, unsigned character) {
    return session.result(
        "proskill/automaton",
        asking({{"format", "json"}, {"position", {{"line", line}, {"character", character}}}}));
  };
  CHECK(at(0, 0)["kind"] == "calls");
  CHECK(at(1, 8)["kind"] == "sv");
  CHECK(at(2, 12)["name"] == "switch_on");
  auto body = at(3, 40);
  CHECK(body["kind"] == "body");
  CHECK(body["content"] == "");
  auto call = partOf(body["nodes"], body["current"]);
  REQUIRE_FALSE(call.is_null());
  CHECK(call["role"] == "call");
  CHECK(call["location"]["range"]["start"]["character"] == 37);
}

TEST_CASE("a broken text has a picture that says so; what has none is an error") {
  Session session;
  session.initialize();
  session.open(kUri, kText + "(defsv ");
  auto picture =
      session.result("proskill/automaton", asking({{"kind", "calls"}, {"format", "dot"}}));
  CHECK(picture["errors"] == true);
  CHECK(picture["content"].get<std::string>().starts_with("digraph"));
  CHECK(session.ask("proskill/automaton",
                    asking({{"kind", "sv"}, {"name", "x"}}))["error"]["code"] == -32803);
  CHECK(session.ask("proskill/automaton", asking({{"kind", "x"}}))["error"]["code"] == -32602);
  CHECK(session.ask("proskill/automaton", asking(Json::object()))["error"]["code"] == -32602);
}

TEST_CASE("a model's lines lead to the program") {
  Session session;
  session.initialize();
  session.open(kUri, kText);
  for (const auto* edition : {"compact", "expanded", "runtime"}) {
    auto model = session.result("proskill/model", asking({{"edition", edition}}));
    CHECK(model["language"] == (edition == std::string("runtime") ? "hfiacre" : "fiacre"));
    const auto text = model["text"].get<std::string>();
    const auto lines = std::count(text.begin(), text.end(), '\n');
    bool found = false;
    for (const auto& range : model["ranges"]) {
      CHECK(range["lastLine"].get<long>() < lines);
      CHECK(range["firstLine"] <= range["lastLine"]);
      if (range["actor"] == "mission" && !range["location"].is_null())
        found = found || range["location"]["range"]["start"]["line"] == 3;
    }
    CHECK(found);
  }
  session.change(kUri, 2, nullptr, "(defsv");
  CHECK(session.ask("proskill/model", asking(Json::object()))["error"]["code"] == -32803);
}

TEST_CASE("places of pictures are in the client's encoding") {
  const std::string text = "(defsv é😀 :states (A B) :init A)\n";
  for (const auto& [encoding, column] :
       {std::pair("utf-8", 19U + 4), std::pair("utf-16", 19U + 1), std::pair("utf-32", 19U)}) {
    Session session({.encoding = encoding});
    session.initialize();
    session.open(kUri, text);
    auto picture =
        session.result("proskill/automaton",
                       asking({{"format", "json"}, {"position", {{"line", 0}, {"character", 1}}}}));
    for (const auto& node : picture["nodes"])
      if (node["label"] == "A") CHECK(node["location"]["range"]["start"]["character"] == column);
  }
}

} // namespace proskill::test::pictures_test
