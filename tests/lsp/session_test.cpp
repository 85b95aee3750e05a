#include "tests/lsp/support/session.h"
#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <latch>
#include <semaphore>

using namespace proskill;
using test::rangeOf;
using test::Session;

namespace {

constexpr auto kMain = "file:///w/main.proskill";
constexpr auto kLamp = "file:///w/lamp.proskill";

const std::string kLampText = "(defsv lamp :states (On Off) :init Off)\n";

int errorOf(const Json& answer) { return answer["error"]["code"].get<int>(); }

std::vector<std::string> codes(const Json& diagnostics) {
  std::vector<std::string> result;
  for (const auto& it : diagnostics) result.push_back(it["code"]);
  return result;
}

/// A file whose reading waits until the test lets it continue.
class GatedFiles : public test::MemoryFiles {
public:
  using MemoryFiles::MemoryFiles;
  std::expected<std::string, std::string> read(const std::filesystem::path& path) const override {
    if (path.filename() == "gated.proskill") {
      reached.release();
      gate.wait();
    }
    return MemoryFiles::read(path);
  }
  mutable std::counting_semaphore<> reached{0};
  mutable std::latch gate{1};
};

} // namespace

TEST_CASE("a session ends with 0 after shutdown, with 1 without") {
  {
    Session session;
    session.initialize();
    CHECK(session.result("shutdown", nullptr) == nullptr);
    session.notify("exit", nullptr);
    CHECK(session.exitCode() == 0);
  }
  {
    Session session;
    session.initialize();
    session.notify("exit", nullptr);
    CHECK(session.exitCode() == 1);
  }
  {
    Session session;
    session.initialize();
    session.hangUp();
    CHECK(session.exitCode() == 1);
  }
}

TEST_CASE("nothing but initialize is answered before initialize, and nothing after shutdown") {
  Session session;
  CHECK(errorOf(session.ask("textDocument/hover", Json::object())) == -32002);
  session.initialize();
  CHECK(errorOf(session.ask("initialize", Json::object())) == -32600);
  session.result("shutdown", nullptr);
  CHECK(errorOf(session.ask("textDocument/hover", Json::object())) == -32600);
}

TEST_CASE("methods and notifications that the server does not know") {
  Session session;
  session.initialize();
  session.notify("textDocument/didDance", Json::object());
  session.notify("$/whatever", Json::object());
  session.notify("proskill/unknown", Json::array());
  CHECK(errorOf(session.ask("proskill/unknown", Json::object())) == -32601);
  CHECK(errorOf(session.ask("$/whatever", Json::object())) == -32601);
}

TEST_CASE("malformed messages are answered as the specification says, and the server goes on") {
  Session session;
  session.initialize();
  auto errorTo = [&](std::string_view body) {
    session.sendBody(body);
    auto answer = session.receive();
    while (answer.contains("method")) answer = session.receive(); // the user is informed, too
    return std::pair(errorOf(answer), answer["id"]);
  };
  CHECK(errorTo("{\"jsonrpc\":") == std::pair(-32700, Json()));
  CHECK(errorTo("\xff\xfe") == std::pair(-32700, Json()));
  CHECK(errorTo("[]") == std::pair(-32600, Json()));
  CHECK(errorTo(R"({"jsonrpc":"1.0","id":7,"method":"shutdown"})") == std::pair(-32600, Json(7)));
  CHECK(errorTo(R"({"jsonrpc":"2.0","id":7,"method":"x","params":3})") ==
        std::pair(-32600, Json(7)));
  session.sendRaw("Content-Length: 99999999999999\r\n\r\n");
  CHECK(errorOf(session.receive()) == -32700);
}

TEST_CASE("parameters of the wrong form are the request's error") {
  Session session;
  session.initialize();
  session.open(kLamp, kLampText);
  for (const auto* method : {"textDocument/definition", "textDocument/references"})
    for (const Json& params :
         {Json(nullptr), Json::array(), Json::object(), Json{{"textDocument", 3}},
          Json{{"textDocument", {{"uri", kLamp}}}},
          Json{{"textDocument", {{"uri", kLamp}}}, {"position", "here"}},
          Json{{"textDocument", {{"uri", kLamp}}}, {"position", {{"line", -1}, {"character", 0}}}},
          Json{{"textDocument", {{"uri", kMain}}}, {"position", {{"line", 0}, {"character", 0}}}}})
      CHECK(errorOf(session.ask(method, params)) == -32602);
}

TEST_CASE("an identifier that waits already is refused, and each request is answered") {
  auto files = std::make_shared<GatedFiles>();
  Session session({.disk = files, .debounce = std::chrono::hours(1)});
  session.initialize();
  session.open(kMain, "(include \"gated.proskill\")");
  auto id = session.send(
      "textDocument/documentHighlight",
      {{"textDocument", {{"uri", kMain}}}, {"position", {{"line", 0}, {"character", 0}}}});
  files->reached.acquire();
  session.sendBody(rpc::request(id, "shutdown", nullptr));
  CHECK(errorOf(session.answer(id)) == -32600);
  files->gate.count_down();
  CHECK(session.answer(id)["result"] == Json::array());
}

TEST_CASE("diagnostics come when a text is opened, and go when it is fixed") {
  Session session;
  session.initialize();
  session.open(kLamp, "; 😀é\n(defsv lamp :states (On Off) :init Of)\n");
  auto first = session.notified("textDocument/publishDiagnostics");
  CHECK(first["uri"] == kLamp);
  CHECK(first["version"] == 1);
  CHECK(codes(first["diagnostics"]).front() == "PS0203");
  CHECK(first["diagnostics"][0]["range"] == rangeOf(1, 35, 37));
  session.change(kLamp, 2, rangeOf(1, 37, 37), "f");
  Json second;
  do second = session.notified("textDocument/publishDiagnostics");
  while (second["version"] != 2);
  for (const auto& code : codes(second["diagnostics"])) CHECK(code != "PS0203");
  session.close(kLamp);
  Json last;
  do last = session.notified("textDocument/publishDiagnostics");
  while (last.contains("version"));
  CHECK(last["uri"] == kLamp);
  CHECK(last["diagnostics"] == Json::array());
}

TEST_CASE("a client that asks for diagnostics is not told") {
  Session session({.pull = true});
  session.initialize();
  session.open(kLamp, "(defsv lamp :states (On Off) :init Of)\n");
  auto report = session.result("textDocument/diagnostic", {{"textDocument", {{"uri", kLamp}}}});
  CHECK(report["kind"] == "full");
  CHECK(codes(report["items"]).front() == "PS0203");
  auto whole = session.result("workspace/diagnostic", {{"previousResultIds", Json::array()}});
  REQUIRE(whole["items"].size() == 1);
  CHECK(whole["items"][0]["uri"] == kLamp);
  CHECK(whole["items"][0]["items"] == report["items"]);
  CHECK_FALSE(session.hasMore());
}

TEST_CASE("a definition is found in an included file, on disk or open") {
  auto disk = std::make_shared<test::MemoryFiles>(
      std::map<std::string, std::string>{{"/w/lamp.proskill", kLampText}});
  Session session({.disk = disk});
  session.initialize();
  session.open(kMain, "(include \"lamp.proskill\")\n(defevent e :effects (lamp On))\n");
  Json expected = Json::array({{{"uri", kLamp}, {"range", rangeOf(0, 7, 11)}}});
  CHECK(session.at("textDocument/definition", kMain, 1, 24) == expected);
  session.open(kLamp, "; 😀\n" + kLampText);
  expected[0]["range"] = rangeOf(1, 7, 11);
  CHECK(session.at("textDocument/definition", kMain, 1, 24) == expected);
  auto references = session.at("textDocument/references", kLamp, 1, 8,
                               {{"context", {{"includeDeclaration", false}}}});
  CHECK(references == Json::array({{{"uri", kMain}, {"range", rangeOf(1, 22, 26)}}}));
}

TEST_CASE("files that get other names are still included") {
  Session session;
  session.initialize();
  session.open(kMain, "(include \"lamp.proskill\")\n");
  session.open(kLamp, kLampText);
  auto rename = [&](const std::string& from, const std::string& to) {
    return session.result("workspace/willRenameFiles",
                          {{"files", Json::array({{{"oldUri", from}, {"newUri", to}}})}});
  };
  const auto edits =
      Json::array({{{"range", rangeOf(0, 10, 23)}, {"newText", "lib/lamp.proskill"}}});
  const auto changes = rename(kLamp, "file:///w/lib/lamp.proskill")["documentChanges"];
  REQUIRE(changes.size() == 1);
  CHECK(changes[0]["textDocument"] == Json{{"uri", kMain}, {"version", 1}});
  CHECK(changes[0]["edits"] == edits);
  CHECK(rename(kMain, "file:///w/mission.proskill").is_null());
}

TEST_CASE("columns are counted as negotiated") {
  const std::string text = "(defsv lamp :states (On Off) :init Off) (defskill s :action (s \"é😀\") "
                           ":start (lamp On))\n";
  auto column = [&](const std::string& encoding) {
    Session session({.encoding = encoding});
    session.initialize();
    session.open(kLamp, text);
    auto places = session.at("textDocument/documentHighlight", kLamp, 0, 8);
    return places[1]["range"]["start"]["character"].get<std::size_t>();
  };
  auto bytes = text.rfind("lamp");
  CHECK(column("utf-8") == bytes);
  CHECK(column("utf-16") == bytes - 1 - 2);
  CHECK(column("") == bytes - 1 - 2);
  CHECK(column("utf-32") == bytes - 1 - 3);
}

TEST_CASE("an edit that does not fit the text closes it, and says so") {
  Session session({.debounce = std::chrono::hours(1)});
  session.initialize();
  session.open(kLamp, kLampText);
  session.change(kLamp, 2, rangeOf(99, 0, 0), "x");
  CHECK(session.notified("window/logMessage")["type"] == 1);
  CHECK(errorOf(session.ask("textDocument/definition",
                            {{"textDocument", {{"uri", kLamp}}},
                             {"position", {{"line", 0}, {"character", 8}}}})) == -32801);
  session.open(kLamp, kLampText, 3);
  CHECK(session.at("textDocument/definition", kLamp, 0, 8).size() == 1);
}

TEST_CASE("a cancelled request is answered at once, while its work still waits") {
  auto files = std::make_shared<GatedFiles>();
  Session session({.disk = files, .debounce = std::chrono::hours(1)});
  session.initialize();
  session.open(kMain, "(include \"gated.proskill\")");
  auto id =
      session.send("textDocument/definition", {{"textDocument", {{"uri", kMain}}},
                                               {"position", {{"line", 0}, {"character", 0}}}});
  files->reached.acquire();
  session.notify("$/cancelRequest", {{"id", id}});
  CHECK(errorOf(session.answer(id)) == -32800);
  files->gate.count_down();
  CHECK(session.result("proskill/status", nullptr)["pending"] == 1); // itself
  CHECK_FALSE(session.hasMore());
}

TEST_CASE("a request that is cancelled before it was handed out is never worked on") {
  auto files = std::make_shared<GatedFiles>();
  Session session({.disk = files, .debounce = std::chrono::hours(1)});
  session.initialize();
  session.open(kLamp, kLampText);
  session.notify("workspace/didChangeWatchedFiles",
                 {{"changes", Json::array({{{"uri", "file:///w/gated.proskill"}, {"type", 2}}})}});
  files->reached.acquire(); // the dispatching thread waits in it
  auto id =
      session.send("textDocument/definition", {{"textDocument", {{"uri", kLamp}}},
                                               {"position", {{"line", 0}, {"character", 8}}}});
  session.notify("$/cancelRequest", {{"id", id}});
  CHECK(errorOf(session.answer(id)) == -32800);
  files->gate.count_down();
  auto status = session.result("proskill/status", nullptr);
  CHECK_FALSE(status["requests"].contains("textDocument/definition"));
}

TEST_CASE(
    "an edit ends what was asked before it, and what the client does not ask again is answered") {
  auto files = std::make_shared<GatedFiles>(
      std::map<std::string, std::string>{{"/w/gated.proskill", kLampText}});
  Session session({.disk = files,
                   .pull = true,
                   .debounce = std::chrono::hours(1),
                   .retried = {"textDocument/references"}});
  session.initialize();
  session.open(kMain,
               "(include \"gated.proskill\")\n(defsv door :states (Open Shut) :init Shut)\n");
  const Json text{{"uri", kMain}};
  const Json place{{"textDocument", text}, {"position", {{"line", 1}, {"character", 8}}}};
  auto retried = session.send("textDocument/references", place);
  auto kept = session.send("textDocument/definition", place);
  auto pulled = session.send("textDocument/diagnostic", {{"textDocument", text}});
  files->reached.acquire();
  session.change(kMain, 2, rangeOf(0, 0, 0), ";\n"); // one line further down
  CHECK(errorOf(session.answer(retried)) == -32801);
  auto refused = session.answer(pulled)["error"];
  CHECK(refused["code"] == -32802);
  CHECK(refused["data"] == Json{{"retriggerRequest", true}});
  files->gate.count_down();
  CHECK(session.answer(kept)["result"][0]["range"] ==
        rangeOf(1, 7, 11)); // of the text before the edit
  auto now = session.at("textDocument/definition", kMain, 2, 8);
  CHECK(now[0]["range"] == rangeOf(2, 7, 11));
}

TEST_CASE("fifty texts at once") {
  Session session({.pull = true});
  session.initialize();
  auto uri = [](int i) { return "file:///w/" + std::to_string(i) + ".proskill"; };
  for (int i = 0; i < 50; ++i) session.open(uri(i), kLampText);
  auto whole = session.result("workspace/diagnostic", {{"previousResultIds", Json::array()}});
  CHECK(whole["items"].size() == 50);
  for (int i = 0; i < 50; ++i) session.close(uri(i));
  whole = session.result("workspace/diagnostic", {{"previousResultIds", Json::array()}});
  CHECK(whole["items"].empty());
}

TEST_CASE("the real program serves on its standard streams") {
  std::string input;
  for (const auto& body :
       {rpc::request(1, "initialize", {{"capabilities", Json::object()}}),
        rpc::notification("initialized", Json::object()), rpc::request(2, "shutdown", nullptr),
        rpc::notification("exit", nullptr)})
    input += rpc::frame(body);
  auto finished =
      test::run({PROSKILL_PROGRAM, "lsp"}, {.input = input, .environment = {}, .onOutput = {}});
  CHECK(finished.exitCode == 0);
  CHECK(finished.err.empty());
  rpc::FrameReader frames;
  frames.feed(finished.out);
  auto first = Json::parse(std::get<std::string>(*frames.next()));
  CHECK(first["result"]["serverInfo"]["name"] == "proskill");
  auto second = Json::parse(std::get<std::string>(*frames.next()));
  CHECK(second == Json{{"jsonrpc", "2.0"}, {"id", 2}, {"result", nullptr}});
  CHECK(
      test::run({PROSKILL_PROGRAM, "lsp"}, {.input = "Content-", .environment = {}, .onOutput = {}})
          .exitCode == 1);
}
