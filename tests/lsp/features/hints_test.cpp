#include "tests/lsp/support/session.h"

#include <catch2/catch.hpp>

namespace proskill::test::hints_test {

using test::rangeOf;
using test::Session;

namespace {

constexpr auto kMain = "file:///w/main.proskill";
constexpr auto kSkills = "file:///w/skills.proskill";
const std::string kSkillsText = "(defskill go :input ($x float) :time_interval [1,3]\n"
                                "  :action (go $x) :success a :failure b)\n";
const std::string kMainText =
    "(include \"skills.proskill\")\n"
    "(defskill m :body (\n  (go x 3)\n  (if (= go.status success) (^ 1))))\n";

/// A client that resolves these members of hints.
Session::Options completing(Json members) {
  return {.capabilities = {
              {"textDocument", {{"inlayHint", {{"resolveSupport", {{"properties", members}}}}}}}}};
}

Json hintsOf(Session& session) {
  session.initialize();
  session.open(kSkills, kSkillsText);
  session.open(kMain, kMainText);
  return session.result("textDocument/inlayHint", {{"textDocument", {{"uri", kMain}}},
                                                   {"range",
                                                    {{"start", {{"line", 0}, {"character", 0}}},
                                                     {"end", {{"line", 4}, {"character", 0}}}}}});
}

/// The duration of `m`, the type of `x`, and the values of `go.status`.
const Json kInput{{"uri", kSkills}, {"range", rangeOf(0, 21, 23)}};
const Json kSkill{{"uri", kSkills}, {"range", rangeOf(0, 10, 12)}};

} // namespace

TEST_CASE("a hint leads to what it speaks about and says what it means") {
  Session session;
  const auto hints = hintsOf(session);
  REQUIRE(hints.size() == 3);
  CHECK(hints[0]["label"].is_string());
  CHECK(hints[0]["tooltip"].get<std::string>().starts_with("From the start"));
  CHECK(hints[1]["label"] == Json::array({{{"value", ": float"}, {"location", kInput}}}));
  CHECK(hints[1]["tooltip"] == "The type of the input `$x` of `go`.");
  CHECK(hints[2]["label"] ==
        Json::array({{{"value", "= success or failure"}, {"location", kSkill}}}));
  CHECK(session.result("inlayHint/resolve", hints[1]) == hints[1]); // it is complete
}

TEST_CASE("what a client completes comes when a hint is looked at") {
  Session whole;
  const auto complete = hintsOf(whole);
  for (const auto& members :
       {Json{"tooltip", "label.location"}, Json::array({"tooltip"}), Json{"label.location"}}) {
    Session session(completing(members));
    const auto hints = hintsOf(session);
    REQUIRE(hints.size() == complete.size());
    for (std::size_t i = 0; i < hints.size(); ++i) {
      INFO(members.dump() << hints[i].dump());
      const bool laterTooltip = std::ranges::count(members, Json("tooltip")) > 0;
      CHECK(hints[i].contains("tooltip") != laterTooltip);
      auto resolved = session.result("inlayHint/resolve", hints[i]);
      CHECK(resolved.erase("data") == 1);
      CHECK(resolved == complete[i]);
    }
  }
}

TEST_CASE("a hint of an earlier text is not completed") {
  Session session(completing({"tooltip", "label.location"}));
  auto hint = hintsOf(session)[1];
  session.change(kMain, 2, rangeOf(0, 0, 0), ";\n");
  CHECK(session.ask("inlayHint/resolve", hint)["error"]["code"] == -32801);
  hint["data"]["version"] = 2; // nor one that does not exist
  CHECK(session.result("inlayHint/resolve", hint) == hint);
  hint["position"] = {{"line", -1}};
  CHECK(session.ask("inlayHint/resolve", hint)["error"]["code"] == -32602);
  session.close(kMain);
  CHECK(session.ask("inlayHint/resolve", hint)["error"]["code"] == -32602);
}

} // namespace proskill::test::hints_test
