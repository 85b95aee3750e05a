#include "tests/lsp/support/session.h"
#include "tests/support/memory_files.h"
#include "tests/support/run.h"

#include "lsp/workspace/workspace.h"

#include <catch2/catch.hpp>

#include <fstream>

namespace proskill::test::fiacre_verification_test {

using test::rangeOf;
using test::Session;

namespace {

constexpr auto kModel = "file:///w/door.fcr";
constexpr auto kEnvironment = "file:///w/a.fcr";

/// It opens, and stays open for ever.
const std::string kDoor = "process Door is\n"
                          "states shut, open\n"
                          "from shut\n"
                          "    wait [1,2];\n"
                          "    to open\n"
                          "component house is par Door end\n"
                          "house\n"
                          "property stays is absent house/1/state open\n"
                          "property opens is present (house/1/state open) within [0,2]\n"
                          "assert stays\n"
                          "assert opens\n";

const Json kLive = {{"verify", {{"delay", 0}, {"seconds", 60}}}};

Json document(const std::string& uri) { return {{"textDocument", {{"uri", uri}}}}; }

Session::Options with(Json settings) {
  Session::Options options;
  options.initializationOptions = std::move(settings);
  return options;
}

/// The next notification on the model in a state.
Json verdictsIn(Session& session, const std::string& state) {
  while (true) {
    auto news = session.notified("proskill/verdicts");
    CHECK(news["program"] == kModel);
    if (news["state"] == state) return news;
  }
}

Json diagnosticsWith(Session& session, bool verdicts) {
  while (true) {
    auto news = session.notified("textDocument/publishDiagnostics");
    if (news["uri"] != kModel) continue;
    Json found = Json::array();
    for (const auto& it : news["diagnostics"])
      if (it["source"] == "proskill verify") found.push_back(it);
    if (found.empty() != verdicts) return found;
  }
}

/// The titles of a line's lenses.
std::vector<std::string> lensesOn(Session& session, int line) {
  std::vector<std::string> titles;
  for (const auto& lens : session.result("textDocument/codeLens", document(kModel)))
    if (lens["range"]["start"]["line"] == line) titles.push_back(lens["command"]["title"]);
  return titles;
}

using Titles = std::vector<std::string>;

} // namespace

TEST_CASE("a model in view is verified, and its verdicts are at its properties") {
  Session session(with(kLive));
  session.initialize();
  session.open(kModel, kDoor);
  const auto news = verdictsIn(session, "done");
  CHECK(news["label"] == "door.fcr");
  CHECK(news["counts"]["errors"] == 1);
  CHECK(news["counts"]["good"] == 2);
  const auto found = diagnosticsWith(session, true);
  REQUIRE(found.size() == 1);
  CHECK(found[0]["range"]["start"] == rangeOf(7, 9, 9)["start"]);
  CHECK(found[0]["data"]["name"] == "stays");
  CHECK(found[0]["relatedInformation"][0]["location"]["range"]["start"]["line"] == 4);
  CHECK(lensesOn(session, 6) == Titles{"✗ 1 bad, 2 good", "verify"});
  CHECK(lensesOn(session, 7) == Titles{"✗ 1 bad", "verify"});
  CHECK(lensesOn(session, 8) == Titles{"✓ 1 good", "verify"});
  auto asked = document(kModel);
  asked["name"] = "stays";
  const auto trace = session.result("proskill/trace", asked);
  CHECK(trace["steps"].size() == 1);
  CHECK(trace["stale"] == false);
}

TEST_CASE("an edit makes the verdicts of a model stale, and a mistake is told in their place") {
  Session session(with(kLive));
  session.initialize();
  session.open(kModel, kDoor);
  verdictsIn(session, "done");
  diagnosticsWith(session, true);
  session.change(kModel, 2, rangeOf(1, 7, 11), "shot");
  CHECK(verdictsIn(session, "errors")["stale"] == true);
  diagnosticsWith(session, false);
  CHECK(lensesOn(session, 8) == Titles{"✓ 1 good (outdated)", "verify"});
  session.change(kModel, 3, rangeOf(1, 7, 11), "shut");
  CHECK(verdictsIn(session, "done")["stale"] == false);
  CHECK(lensesOn(session, 8) == Titles{"✓ 1 good", "verify"});
}

TEST_CASE("a property of a model is verified when that is asked for") {
  Session session(with({{"verify", {{"live", false}}}}));
  session.initialize();
  session.open(kModel, kDoor);
  CHECK(lensesOn(session, 8) == Titles{"verify"});
  auto params = document(kModel);
  params["names"] = {"opens"};
  const auto result = session.result("proskill/verify", params);
  REQUIRE(result["verdicts"].size() == 1);
  CHECK(result["verdicts"][0]["verdict"] == "holds");
  params["names"] = {"closes"};
  CHECK(session.ask("proskill/verify", params)["error"]["message"] ==
        "no property is called `closes`");
  session.change(kModel, 2, rangeOf(1, 7, 11), "shot");
  params["names"] = Json::array();
  const auto refused = session.ask("proskill/verify", params)["error"]["message"];
  CHECK(refused.get<std::string>().starts_with("the program has errors: "));
}

TEST_CASE("in a workspace that is not trusted no model is verified") {
  Session session(with({{"trusted", false}, {"verify", {{"delay", 0}}}}));
  session.initialize();
  session.open(kModel, kDoor);
  CHECK(verdictsIn(session, "off")["message"].get<std::string>().find("not trusted") !=
        std::string::npos);
  CHECK(session.ask("proskill/verify", document(kModel))["error"]["code"] == -32803);
}

TEST_CASE("environments and properties alone are checked, and not verified") {
  Session session(with(kLive));
  session.initialize();
  const std::string text = "process E [go: sync] is\nstates a\nfrom a\n    go;\n    to a\n"
                           "property p is absent model/tag done\nassert p\n";
  session.open(kEnvironment, text);
  CHECK(session.notified("textDocument/publishDiagnostics")["diagnostics"].empty());
  CHECK(session.result("textDocument/codeLens", document(kEnvironment)).empty());
  CHECK(session.ask("proskill/verify", document(kEnvironment))["error"]["message"] ==
        "the text names no model");
  session.open(kModel, kDoor);
  verdictsIn(session, "done"); // all notifications concern the model
  session.change(kEnvironment, 2, rangeOf(4, 7, 8), "b");
  CHECK(session.notified("textDocument/publishDiagnostics")["uri"].is_string());
}

TEST_CASE("mistakes of models that are not open are told, too") {
  auto disk = std::make_shared<test::MemoryFiles>(std::map<std::string, std::string>{
      {"/w/door.fcr", "process Door is states shut from shot to shut\nDoor\n"}});
  Session session({.disk = disk, .pull = true});
  session.initialize();
  session.notify("workspace/didChangeWatchedFiles",
                 {{"changes", Json::array({{{"uri", kModel}, {"type", 1}}})}});
  const auto all = session.result("workspace/diagnostic", {{"previousResultIds", Json::array()}});
  REQUIRE(all["items"].size() == 1);
  CHECK(all["items"][0]["uri"] == kModel);
  REQUIRE(all["items"][0]["items"].size() == 1);
  const auto message = all["items"][0]["items"][0]["message"].get<std::string>();
  CHECK_THAT(message, Catch::Contains("`shot`"));
}

TEST_CASE("the models of a folder are found") {
  test::TemporaryDirectory directory;
  for (const auto* name : {"a.fcr", "b.proskill", "c.txt"})
    std::ofstream(directory.path(name)) << "main";
  std::vector<std::string> found;
  for (const auto& path : lsp::programFiles(directory.path(""))) found.push_back(path.filename());
  CHECK(found == std::vector<std::string>{"a.fcr", "b.proskill"});
}

} // namespace proskill::test::fiacre_verification_test
