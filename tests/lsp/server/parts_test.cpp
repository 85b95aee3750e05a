#include "lsp/server/parent_watch.h"
#include "lsp/server/server_log.h"
#include "lsp/server/settings_mistakes.h"
#include "lsp/server/statistics.h"
#include "tests/lsp/server/support.h"

#include <catch2/catch.hpp>

#include <unistd.h>

using namespace proskill;
using namespace std::chrono_literals;

namespace {

rpc::Message hoverRequest() {
  return {.kind = rpc::MessageKind::Request,
          .id = 7,
          .method = "textDocument/hover",
          .params = {{"line", 3}}};
}

} // namespace

TEST_CASE("latencies are counted by method, and their quantiles are of the last thousand") {
  lsp::Statistics statistics;
  CHECK(statistics.latencies() == Json::object());
  for (int i = 1; i <= 1100; ++i) statistics.add("a", std::chrono::milliseconds(i));
  statistics.add("b", 2ms);
  const auto all = statistics.latencies();
  CHECK(all["a"] == Json{{"count", 1100}, {"p50", 601.0}, {"p99", 1090.0}, {"max", 1100.0}});
  CHECK(all["b"]["count"] == 1);
  CHECK(all["b"]["p50"] == 2.0);
}

TEST_CASE("the log has every answer, and the client those that it wants to see") {
  test::Client client;
  std::vector<std::string> lines;
  lsp::ServerLog log([&](std::string_view line) { lines.emplace_back(line); }, client.peer);
  const auto answer = [&] { log.writeAnswer(hoverRequest(), "ok", 1500us); };
  answer();
  CHECK_FALSE(client.pipe.hasMore());
  log.setTrace("messages");
  log.setTrace("loudly"); // ignored
  answer();
  CHECK(client.pipe.receive()["params"] == Json{{"message", "textDocument/hover 7 1.500 ms ok"}});
  log.setTrace("verbose");
  answer();
  CHECK(client.pipe.receive()["params"]["verbose"] == R"({"line":3})");
  log.setTrace("off");
  answer();
  CHECK_FALSE(client.pipe.hasMore());
  REQUIRE(lines.size() == 4);
  CHECK(lines[0].ends_with("Z textDocument/hover 7 1.500 ms ok"));
}

TEST_CASE("an error of a settings file is published once, and withdrawn when it is gone") {
  test::Client client;
  const lsp::ClientFeatures features;
  lsp::SettingsMistakes mistakes(client.peer, features);
  const report::SettingsMistake mistake{"unknown key", "{\n  \"stile\": true\n}", {4, 11}};
  mistakes.publish({{"/w/.proskill.json", mistake}});
  const auto said = client.pipe.receive()["params"];
  CHECK(said["uri"] == "file:///w/.proskill.json");
  CHECK(said["diagnostics"][0]["message"] == "unknown key");
  CHECK(said["diagnostics"][0]["range"]["start"] == Json{{"line", 1}, {"character", 2}});
  mistakes.publish({{"/w/.proskill.json", mistake}});
  CHECK_FALSE(client.pipe.hasMore());
  mistakes.publish({});
  CHECK(client.pipe.receive()["params"]["diagnostics"] == Json::array());
}

TEST_CASE("only a process that runs here is watched, and not before a look is due") {
  CHECK_FALSE(lsp::ParentWatch().due());
  for (const Json& none : {Json(), Json("1"), Json(-1), Json(std::uint64_t{1} << 40)})
    CHECK_FALSE(lsp::ParentWatch(none).due());
  lsp::ParentWatch watch(Json(static_cast<unsigned>(getpid())));
  CHECK(watch.due());
  CHECK_FALSE(watch.isGone());
}
