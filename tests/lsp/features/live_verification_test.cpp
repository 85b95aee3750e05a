#include "disk/disk.h"
#include "report/uri.h"
#include "tests/lsp/support/lamp.h"
#include "tests/support/run.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace proskill::test::live_verification_test {

using namespace lamp;

namespace {

/// A program of 100^12 states.
std::string largeText() {
  constexpr int kCounters = 12;
  std::string text = "(defproperty near (always (<= x0 (+ x1 51))))\n";
  for (int i = 0; i < kCounters; ++i)
    text += fmt::format("(defsv x{0} :min 0 :max 99 :init 0)\n"
                        "(defevent up{0} :guard (& (< x{0} 99) (<= x{0} (+ x{1} 50))) :effects "
                        "(x{0} (+ x{0} 1)))\n",
                        i, (i + 1) % kCounters);
  return text;
}

} // namespace

TEST_CASE("the program in view is verified, and its verdicts are diagnostics") {
  Session::Options options;
  options.initializationOptions = kLive;
  Session session(options);
  openLamp(session, kBad);
  auto news = verdictsIn(session, "done");
  CHECK(news["stale"] == false);
  CHECK(news["label"] == "main.proskill");
  CHECK(news["counts"]["errors"] == 1);
  auto found = diagnosticsWith(session, kLamp, true);
  REQUIRE(found.size() == 1);
  CHECK(found[0]["range"] == rangeOf(0, 7, 11));
  CHECK(found[0]["severity"] == 1);
  CHECK(found[0]["code"] == "no_forbidden_transition");
  CHECK(found[0]["data"] ==
        Json({{"kind", "verdict"}, {"name", "lamp.no_forbidden_transition"}, {"program", kMain}}));
  auto way = found[0]["relatedInformation"];
  REQUIRE(way.size() >= 2);
  CHECK(way[0]["location"]["uri"] == kMain);
  CHECK(way[0]["location"]["range"]["start"]["line"] == 1);
}

TEST_CASE("the programs of all texts that were opened are verified, that in view first") {
  Session::Options options;
  options.initializationOptions = kLive;
  options.initializationOptions["verify"]["delay"] = 1'000; // both are open by then
  Session session(options);
  session.initialize();
  const std::string text = "(defsv door :states (Open Closed) :init Open)\n"
                           "(defevent close :effects (door Closed))\n";
  const std::string other = "file:///w/other.proskill";
  session.open(kMain, text);
  session.open(other, text);
  std::vector<std::string> done;
  while (done.size() < 2) {
    const auto news = session.notified("proskill/verdicts");
    const auto program = news["program"].get<std::string>();
    if (news["state"] == "done" && std::ranges::find(done, program) == done.end())
      done.push_back(program);
  }
  CHECK(done == std::vector<std::string>{other, kMain});
}

TEST_CASE("a program that is opened does not wait for one that is no longer in view") {
  Session::Options options;
  options.initializationOptions = kLive;
  options.initializationOptions["verify"]["seconds"] = 20;
  Session session(options);
  session.initialize();
  session.open(kMain, largeText());
  verdictsIn(session, "checking");
  const std::string other = "file:///w/other.proskill";
  session.open(other, "(defsv door :states (Open Closed) :init Open)\n"
                      "(defevent close :effects (door Closed))\n");
  Json news;
  while (news["state"] != "done") news = session.notified("proskill/verdicts");
  CHECK(news["program"] == other); // otherwise the first verification has reached its limit
}

TEST_CASE("verdicts are outdated while a text of their program is not known") {
  const std::string lost = GENERATE(kMain, kLamp);
  Session::Options options;
  options.initializationOptions = kLive;
  Session session(options);
  openLamp(session, kBad);
  verdictsIn(session, "done");
  session.open(kLamp, kLampText);
  const auto changed = [&](int version, const std::string& change) {
    session.sendBody(fmt::format(
        R"({{"jsonrpc":"2.0","method":"textDocument/didChange","params":{{"textDocument":{{"uri":"{}","version":{}}},"contentChanges":[{}]}}}})",
        lost, version, change));
  };
  changed(
      2,
      R"({"range":{"start":{"line":0,"character":0},"end":{"line":0,"character":0}},"text":"\ud83d"})");
  auto news = verdictsIn(session, "waiting");
  CHECK(news["stale"] == true);
  CHECK(news["counts"]["errors"] == 1);
  changed(3, Json{{"text", lost == kMain ? kBad : kLampText}}.dump());
  news = verdictsIn(session, "done");
  CHECK(news["stale"] == false);
}

TEST_CASE("a request for one property leaves the others to live verification") {
  Session::Options options;
  options.initializationOptions = kLive;
  options.initializationOptions["verify"]["delay"] = 1'500; // the request comes first
  Session session(options);
  openLamp(session, kBad);
  const auto result =
      session.result("proskill/verify", verifying(kMain, {"lamp.no_forbidden_transition"}));
  CHECK(result["verdicts"].size() == 1);
  Json news;
  do news = verdictsIn(session, "done");
  while (news["verdicts"].size() < 2);
  CHECK(news["stale"] == false);
}

TEST_CASE("after live verification the durations of skills are measured, and hovers show them") {
  const bool isEdited = GENERATE(false, true);
  const std::string text = "(defsv n :states (A B) :init A)\n"
                           "(defskill drive :time_interval [2,5] :action (go))\n"
                           "(defskill m :body ((drive) (set (n B))))\n";
  const auto isShown = [](Session& session) {
    const auto shown = session.at("textDocument/hover", kMain, 1, 11);
    return shown["contents"].dump().find("Takes 2 to 5 s") != std::string::npos;
  };
  Session::Options options;
  options.initializationOptions = kLive;
  options.capabilities["workspace"]["codeLens"]["refreshSupport"] = true;
  Session session(options);
  session.initialize();
  session.open(kMain, text);
  if (isEdited) { // the measurement ends, and begins again
    while (verdictsIn(session, "done")["stale"] == true) continue;
    session.change(kMain, 2, rangeOf(2, 0, 0), ";");
    session.change(kMain, 3, rangeOf(2, 0, 1), "");
  }
  while (!isShown(session)) (void)session.notified("workspace/codeLens/refresh");
  const auto lenses = session.result("textDocument/codeLens", document(kMain));
  CHECK(lenses.dump().find("good · 2 to 5 s") != std::string::npos);
}

TEST_CASE("a measured duration is the same in lens and hint, and tighter than the computed one") {
  Session::Options options;
  options.initializationOptions = kLive;
  options.capabilities["workspace"]["inlayHint"]["refreshSupport"] = true;
  Session session(options);
  session.initialize();
  session.open(kMain, "(defsv n :states (A B) :init (A B))\n"
                      "(defskill m :body ((if (n A) (^ 4)) (if (n B) (^ 8))))\n");
  const auto hint = [&] {
    auto asked = document(kMain);
    asked["range"] = rangeOf(1, 0, 11);
    return session.result("textDocument/inlayHint", asked)[0];
  };
  while (hint()["label"] == "0 to 12 s") (void)session.notified("workspace/inlayHint/refresh");
  CHECK(hint()["label"] == "4 to 8 s");
  CHECK(hint()["tooltip"] == "Takes 4 to 8 s, over all runs of the program.");
  const auto lenses = session.result("textDocument/codeLens", document(kMain));
  CHECK(lenses.dump().find("good · 4 to 8 s") != std::string::npos);
}

TEST_CASE("findings and verdicts on an imported program name their originals") {
  Session::Options options;
  options.initializationOptions = kLive;
  Session session(options);
  const auto bad = "(include \"lamp.proskill\")\n; from in/robot.rl:7:5 event off\n"
                   "(defevent off :effects (lamp Off))\n(defevent on :effects (lamp On))\n";
  session.initialize();
  session.open(kLamp, "; from in/robot.rl:3:9 resource lamp\n" + kLampText);
  session.open(kMain, bad);
  const auto verdict = diagnosticsWith(session, kLamp, true);
  REQUIRE(verdict.size() == 1);
  const auto& first = verdict[0]["relatedInformation"][0];
  CHECK(first["message"] == "from here: resource lamp");
  CHECK(first["location"]["uri"] == "file:///w/in/robot.rl");
  CHECK(first["location"]["range"] == rangeOf(2, 8, 8));
}

TEST_CASE("an error in an imported program names its original") {
  Session session;
  session.initialize();
  session.open(kMain, "; from in/robot.rl:7:5 event off\n(defevent off :effects (lamp Off))\n");
  const auto told = session.result("textDocument/diagnostic", document(kMain))["items"];
  REQUIRE(told.size() == 1);
  const auto& original = told[0]["relatedInformation"][0];
  CHECK(original["message"] == "from here: event off");
  CHECK(original["location"]["uri"] == "file:///w/in/robot.rl");
  CHECK(original["location"]["range"] == rangeOf(6, 4, 4));
}

TEST_CASE("a client that puts verdicts together is told those alone that have changed") {
  Session::Options options;
  options.initializationOptions = kLive;
  options.capabilities["experimental"]["verdicts"] = "changes";
  Session session(options);
  openLamp(session, kBad);
  Json known;
  const auto until = [&](const std::string& state, bool stale) {
    while (true) {
      auto news = session.notified("proskill/verdicts");
      if (news["program"] != kMain) continue; // the lamp was briefly a program of its own
      if (news["changes"] == false) known.clear();
      for (const auto& verdict : news["verdicts"]) known[verdict["name"]] = verdict;
      if (news["state"] == state && news["stale"] == stale) return news;
    }
  };
  auto news = until("done", false);
  const auto verified = session.result("proskill/verify", verifying(kMain))["verdicts"];
  CHECK(known.size() == verified.size());
  for (const auto& verdict : verified) CHECK(known[verdict["name"]] == verdict);
  session.change(kLamp, 2, rangeOf(1, 24, 24), " (On Off)");
  news = until("waiting", true);
  CHECK(news["changes"] == true);
  CHECK(news["verdicts"].empty());
  CHECK(news["counts"]["errors"] == 1);
  CHECK(known["lamp.no_forbidden_transition"]["verdict"] == "violated");
  until("done", false);
  CHECK(known["lamp.no_forbidden_transition"]["verdict"] == "holds");
  CHECK(known.size() == verified.size());
}

TEST_CASE("a client that does not ask for verdicts is sent none, and has them as diagnostics") {
  Session::Options options;
  options.initializationOptions = kLive;
  options.capabilities["experimental"]["verdicts"] = nullptr;
  Session session(options);
  openLamp(session, kBad);
  CHECK(diagnosticsWith(session, kLamp, true).size() == 1);
  CHECK_FALSE(session.wasNotified("proskill/verdicts"));
}

TEST_CASE("an edit makes verdicts stale at once; what is taken back makes them current") {
  Session::Options options;
  options.initializationOptions = {{"verify", {{"delay", 0}, {"seconds", 60}}}};
  Session session(options);
  openLamp(session, kBad);
  verdictsIn(session, "done");
  diagnosticsWith(session, kLamp, true);
  // A text with errors is not verified; the known verdicts are for the older text.
  session.change(kMain, 2, rangeOf(0, 0, 0), "(");
  auto news = verdictsIn(session, "errors");
  CHECK(news["stale"] == true);
  CHECK(news["texts"][0]["version"] == 1);
  diagnosticsWith(session, kLamp, false);
  session.change(kMain, 3, rangeOf(0, 0, 1), "");
  CHECK(verdictsIn(session, "done")["stale"] == false);
  CHECK(diagnosticsWith(session, kLamp, true).size() == 1);
}

TEST_CASE("a file that a refactoring opens and closes leaves no outdated verdicts") {
  Session::Options options;
  options.initializationOptions = kLive;
  options.disk = std::make_shared<test::MemoryFiles>(
      std::map<std::string, std::string>{{"/w/lamp.proskill", kLampText}});
  Session session(options);
  session.initialize();
  session.open(kMain, kGood);
  verdictsIn(session, "done");
  session.open(kLamp, kLampText);
  session.change(kLamp, 2, rangeOf(1, 24, 24), " (On Off)");
  CHECK(verdictsIn(session, "done")["stale"] == false);
  session.close(kLamp); // nothing was saved
  CHECK(verdictsIn(session, "waiting")["stale"] == true);
  CHECK(verdictsIn(session, "done")["stale"] == false);
}

TEST_CASE("a file that turns out to be part of a program has no verification of its own any more") {
  Session::Options options;
  options.initializationOptions = kLive;
  Session session(options);
  session.initialize();
  const std::string part = "file:///w/part.proskill";
  session.open(part, "(defevent off :effects (lamp Off))\n");
  verdictsIn(session, "errors", part);
  session.open(kLamp, kLampText);
  session.open(kMain, kGood + "(include \"part.proskill\")\n");
  CHECK(verdictsIn(session, "off", part)["message"] == "the file is part of a program");
  CHECK(verdictsIn(session, "done")["counts"]["errors"] == 1);
}

TEST_CASE("a program whose first file is gone has no verdicts, though a part of it is open") {
  const TemporaryDirectory folder;
  const auto root = folder.write("main.proskill", kGood);
  const auto part = folder.write("lamp.proskill", kLampText);
  Session::Options options;
  options.initializationOptions = kLive;
  options.disk = std::make_shared<disk::DiskFileSystem>();
  Session session(options);
  session.initialize();
  const auto uri = report::toUri(root);
  session.open(uri, kGood);
  verdictsIn(session, "done", uri);
  session.open(report::toUri(part), kLampText);
  session.close(uri);
  verdictsIn(session, "done", uri);
  std::filesystem::remove(root);
  session.notify("workspace/didChangeWatchedFiles",
                 {{"changes", Json::array({{{"uri", uri}, {"type", 3}}})}});
  CHECK(verdictsIn(session, "off", uri)["message"] == "the file does not exist any more");
}

TEST_CASE("a verification ends when a file of the program, though not open, disappears") {
  const TemporaryDirectory folder;
  const auto part = folder.write("part.proskill", largeText());
  const auto root = folder.write("main.proskill", "(include \"part.proskill\")\n");
  Session::Options options;
  options.initializationOptions = kLive;
  options.initializationOptions["verify"]["seconds"] = 20;
  options.disk = std::make_shared<disk::DiskFileSystem>();
  Session session(options);
  session.initialize();
  const auto uri = report::toUri(root);
  session.open(uri, "(include \"part.proskill\")\n");
  verdictsIn(session, "checking", uri);
  std::filesystem::remove(part);
  session.notify("workspace/didChangeWatchedFiles",
                 {{"changes", Json::array({{{"uri", report::toUri(part)}, {"type", 3}}})}});
  std::string state = "checking";
  while (state == "checking" || state == "waiting")
    state = session.notified("proskill/verdicts")["state"].get<std::string>();
  CHECK(state == "errors"); // otherwise the verification has reached its limit
}

} // namespace proskill::test::live_verification_test
