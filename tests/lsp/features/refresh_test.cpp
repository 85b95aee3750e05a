#include "lsp/server/refresher.h"
#include "tests/lsp/support/session.h"

#include <catch2/catch.hpp>

#include <set>

namespace proskill::test::refresh_test {

using test::MemoryFiles;
using test::rangeOf;
using test::Session;

namespace {

using Methods = std::multiset<std::string>;

constexpr auto kMain = "file:///w/main.proskill";
constexpr auto kLamp = "file:///w/lamp.proskill";

const std::string kLampText = "(defsv lamp :states (On Off) :init Off)\n";
const std::string kMainText = "(include \"lamp.proskill\")\n(defevent e :effects (lamp On))\n";

const Methods kOfTexts{"workspace/semanticTokens/refresh", "workspace/inlayHint/refresh",
                       "workspace/inlineValue/refresh", "workspace/codeLens/refresh",
                       "workspace/diagnostic/refresh"};
const Methods kOfFindings{"workspace/diagnostic/refresh"};
const Methods kNone;

Json ableToRefresh() {
  Json workspace;
  for (const auto* what : {"semanticTokens", "inlayHint", "inlineValue", "codeLens", "diagnostics"})
    workspace[what] = {{"refreshSupport", true}};
  return {{"workspace", workspace}};
}

lsp::ClientFeatures pullingClient() {
  auto capabilities = ableToRefresh();
  capabilities["textDocument"]["diagnostic"] = Json::object();
  return lsp::readClientFeatures(capabilities);
}

/// Texts in an editor, and the refreshes that its client receives.
class Editor {
public:
  using Files = std::map<std::string, std::string>;

  explicit Editor(lsp::ClientFeatures client = pullingClient()) : client(std::move(client)) {}

  /// Replaces the texts. \param changed one of them, or a file on disk
  void set(const Files& texts, const std::string& changed) {
    ide::OpenTexts open;
    for (const auto& [name, text] : texts)
      open["/w/" + name] = {"file:///w/" + name, 1, syntax::Document::parse(text)};
    const auto before = std::exchange(snapshot, snapshotOf(open));
    refresher.changed("/w/" + changed, *before, {});
  }

  Methods refreshed() {
    if (!refresher.due()) return {};
    refresher.refresh(*snapshot);
    Methods methods;
    while (pipe.hasMore()) methods.insert(pipe.receive()["method"].get<std::string>());
    return methods;
  }

  lsp::ClientFeatures client;
  test::Pipe pipe;
  rpc::Outbox outbox{pipe};
  rpc::Peer peer{outbox};
  lsp::Refresher refresher{peer, client};

private:
  static std::shared_ptr<const ide::Snapshot> snapshotOf(const ide::OpenTexts& open) {
    auto disk = std::make_shared<MemoryFiles>();
    auto graph = ide::graphOf(*disk, open);
    return std::make_shared<const ide::Snapshot>(std::move(disk), open, std::move(graph));
  }

  std::shared_ptr<const ide::Snapshot> snapshot = snapshotOf({});
};

} // namespace

TEST_CASE("what is shown of a text is asked for again when another of its program changes") {
  Editor editor;
  Editor::Files texts{{"main.proskill", kMainText}};
  auto changed = [&](const std::string& file) {
    editor.set(texts, file);
    return editor.refreshed();
  };
  CHECK(changed("main.proskill") == kNone);    // no other text is open
  CHECK(changed("lamp.proskill") == kOfTexts); // on disk
  CHECK(changed("alone.proskill") == kNone);
  texts["lamp.proskill"] = kLampText;
  CHECK(changed("lamp.proskill") == kOfTexts);
  CHECK(changed("main.proskill") == kOfTexts);
  texts["alone.proskill"] = kLampText;
  CHECK(changed("alone.proskill") == kNone);
  texts.erase("lamp.proskill");
  CHECK(changed("lamp.proskill") == kOfTexts);
  texts.erase("main.proskill");
  CHECK(changed("main.proskill") == kNone);
}

TEST_CASE("an edit that joins programs or separates them is one of both") {
  Editor editor;
  Editor::Files texts{{"main.proskill", "(defevent e)"}, {"lamp.proskill", kLampText}};
  editor.set(texts, "main.proskill");
  CHECK(editor.refreshed() == kNone);
  texts["main.proskill"] = kMainText;
  editor.set(texts, "main.proskill");
  CHECK(editor.refreshed() == kOfTexts);
  texts["main.proskill"] = "";
  editor.set(texts, "main.proskill");
  CHECK(editor.refreshed() == kOfTexts);
  editor.set(texts, "main.proskill");
  CHECK(editor.refreshed() == kNone);
}

TEST_CASE("many edits are followed by one question, when the texts have been left alone") {
  Editor editor;
  for (int i = 0; i < 9; ++i)
    editor.set({{"main.proskill", kMainText}, {"lamp.proskill", kLampText}}, "lamp.proskill");
  CHECK(editor.refreshed() == kOfTexts);
  CHECK(editor.refreshed() == kNone);
}

TEST_CASE("a client that leaves is asked nothing") {
  Editor editor;
  editor.refresher.allChanged({});
  editor.refresher.stop();
  CHECK_FALSE(editor.refresher.due());
  editor.refresher.allChanged({}); // by work in progress
  CHECK_FALSE(editor.refresher.due());
}

TEST_CASE("settings weigh findings, and folders may join any texts") {
  Editor editor;
  editor.refresher.findingsChanged({});
  CHECK(editor.refreshed() == kOfFindings);
  editor.refresher.allChanged({});
  CHECK(editor.refreshed() == kNone); // no text is open
  editor.set({{"main.proskill", kMainText}}, "main.proskill");
  editor.refresher.allChanged({});
  CHECK(editor.refreshed() == kOfTexts);
}

TEST_CASE("a client is asked only what it takes") {
  auto telling = pullingClient();
  telling.refreshes.erase("workspace/diagnostic/refresh");
  Editor poor(lsp::readClientFeatures(Json::object()));
  poor.refresher.allChanged({});
  CHECK_FALSE(poor.refresher.due());
  const auto pushed = lsp::readClientFeatures(ableToRefresh()); // its findings are published anyway
  CHECK(pushed.refreshes == telling.refreshes);
}

TEST_CASE("edits, texts, files and folders have a client ask again") {
  Session session({.pull = true, .capabilities = ableToRefresh()});
  session.initialize();
  constexpr auto kMethod = "workspace/semanticTokens/refresh";
  session.open(kMain, kMainText);
  session.open(kLamp, kLampText);
  (void)session.notified(kMethod);
  session.change(kLamp, 2, rangeOf(0, 7, 11), "light");
  (void)session.notified(kMethod);
  session.close(kLamp);
  (void)session.notified(kMethod);
  session.notify("workspace/didChangeWatchedFiles",
                 {{"changes", Json::array({{{"uri", kLamp}, {"type", 2}}})}});
  (void)session.notified(kMethod);
  session.notify("workspace/didChangeWorkspaceFolders",
                 {{"event", {{"added", Json::array()}, {"removed", Json::array()}}}});
  (void)session.notified(kMethod);
  session.notify("workspace/didChangeConfiguration",
                 {{"settings", {{"proskill", {{"diagnostics", {{"style", true}}}}}}}});
  (void)session.notified("workspace/diagnostic/refresh");
}

TEST_CASE("hints of a large program are asked for again when its flow is known") {
  Session session({.capabilities = ableToRefresh()});
  session.initialize();
  std::string text = "(defsv lamp :states (On Off) :init Off :transitions :all)\n"
                     "(defskill m :body ((set (lamp On)) (if (lamp On) (^ 1))))\n";
  for (int i = 0; i < 2'000; ++i)
    text += "; as large as many programs: in other words, very large\n";
  session.open(kMain, text);
  const Json all{
      {"textDocument", {{"uri", kMain}}},
      {"range",
       {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 2}, {"character", 0}}}}}};
  // It may already be known: a client that gets everything is not asked again.
  if (session.result("textDocument/inlayHint", all).empty())
    (void)session.notified("workspace/inlayHint/refresh");
  CHECK(session.result("textDocument/inlayHint", all).size() == 2);
}

TEST_CASE("Neovim is told diagnostics: it does not ask again for those of other open texts") {
  auto capabilities = ableToRefresh();
  capabilities["textDocument"]["diagnostic"] = Json::object();
  const auto neovim = lsp::readClientFeatures(capabilities, "Neovim");
  CHECK_FALSE(neovim.pullDiagnostics);
  CHECK_FALSE(neovim.refreshes.contains("workspace/diagnostic/refresh"));
  CHECK(lsp::readClientFeatures(capabilities, "another").pullDiagnostics);
}

} // namespace proskill::test::refresh_test
