#include "lsp/server/publisher.h"
#include "tests/lsp/server/support.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace std::chrono_literals;

namespace {

constexpr const char* kUri = "file:///w/lamp.proskill";
constexpr const char* kRight = "; Nothing is wrong here.\n";
constexpr const char* kWrong = "(defsv lamp :states (On Off) :init Of)\n";

/// A publisher with an editor in which texts are open.
struct EditorTexts {
  test::Client client;
  lsp::Workspace workspace{std::make_shared<test::MemoryFiles>()};
  lsp::Statistics statistics;
  lsp::ClientFeatures features;
  std::vector<std::string> failures;
  std::shared_ptr<const ide::Verdicts> verdicts = std::make_shared<const ide::Verdicts>();
  std::function<void()> onComputing = [] {}; ///< called by the thread that publishes
  rpc::Scheduler scheduler{2};
  lsp::Publisher publisher{client.peer,
                           scheduler,
                           statistics,
                           features,
                           [this] {
                             onComputing();
                             return verdicts;
                           },
                           [](const ide::Snapshot&) {},
                           [this](std::string_view, const Json& params, std::string_view error) {
                             failures.push_back(params["uri"].get<std::string>() + ": " +
                                                std::string(error));
                           }};

  void open(const char* text, int version) {
    const Json document{{"uri", kUri}, {"text", text}, {"version", version}};
    REQUIRE(workspace.open({{"textDocument", document}}));
    publisher.changed(0ms);
  }
  void publish(bool enabled = true) {
    publisher.publish(workspace.snapshot(), enabled);
    test::settle(scheduler);
  }
  /// The parameters of the next diagnostics.
  Json told() {
    const auto message = client.pipe.receive();
    CHECK(message["method"] == "textDocument/publishDiagnostics");
    return message["params"];
  }
};

} // namespace

TEST_CASE("diagnostics are due after the delay, and until they are published") {
  EditorTexts editor;
  CHECK_FALSE(editor.publisher.due());
  const auto before = std::chrono::steady_clock::now();
  editor.publisher.changed(1h);
  CHECK(editor.publisher.due() >= before + 1h);
  editor.publish();
  CHECK_FALSE(editor.publisher.due());
}

TEST_CASE("diagnostics are sent once for each version of a text") {
  EditorTexts editor;
  editor.open(kWrong, 1);
  editor.publish();
  const auto wrong = editor.told();
  CHECK(wrong["uri"] == kUri);
  CHECK(wrong["version"] == 1);
  CHECK(wrong["diagnostics"].size() == 1);
  editor.publish();
  CHECK_FALSE(editor.client.pipe.hasMore());
  editor.open(kRight, 2);
  editor.publish();
  const auto right = editor.told();
  CHECK(right["version"] == 2);
  CHECK(right["diagnostics"].empty());
}

TEST_CASE("new verdicts are published although the text is the same") {
  EditorTexts editor;
  editor.open(kRight, 1);
  editor.publish();
  CHECK(editor.told()["version"] == 1);
  editor.verdicts = std::make_shared<const ide::Verdicts>();
  editor.publish();
  CHECK(editor.told()["version"] == 1);
}

TEST_CASE("what was computed for an older text is not published") {
  EditorTexts editor;
  editor.open(kWrong, 1);
  editor.onComputing = [&] { editor.publisher.changed(0ms); };
  editor.publish();
  CHECK_FALSE(editor.client.pipe.hasMore());
  editor.onComputing = [] {};
  editor.publish();
  CHECK(editor.told()["version"] == 1);
}

TEST_CASE("diagnostics are withdrawn from a closed text, and from all when they are switched off") {
  EditorTexts editor;
  editor.open(kWrong, 1);
  editor.publish();
  CHECK(editor.told()["diagnostics"].size() == 1);
  SECTION("closed") {
    REQUIRE(editor.workspace.close({{"textDocument", {{"uri", kUri}}}}));
    editor.publish();
  }
  SECTION("switched off") { editor.publish(false); }
  CHECK(editor.told() == Json{{"uri", kUri}, {"diagnostics", Json::array()}});
  editor.publish(false);
  CHECK_FALSE(editor.client.pipe.hasMore());
}

TEST_CASE("a failure to compute diagnostics is told, and the next edit has them again") {
  EditorTexts editor;
  editor.open(kWrong, 1);
  editor.onComputing = [] { throw std::runtime_error("no memory"); };
  editor.publish();
  CHECK(editor.failures == std::vector{std::string(kUri) + ": no memory"});
  CHECK_FALSE(editor.client.pipe.hasMore());
  editor.onComputing = [] {};
  editor.open(kRight, 2);
  editor.publish();
  CHECK(editor.told()["version"] == 2);
}
