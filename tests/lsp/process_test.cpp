#include "process/child.h"
#include "rpc/framing.h"
#include "rpc/rpc.h"
#include "tests/support/endless_program.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <vector>

#include <poll.h>

using namespace proskill;

namespace {

/// `proskill lsp` as a process, and its output.
class ServerProcess {
public:
  ServerProcess() : child(started()) {
    send(rpc::request(1, "initialize",
                      {{"capabilities", {{"experimental", {{"verdicts", "all"}}}}},
                       {"initializationOptions", {{"verify", {{"delay", 0}, {"seconds", 600}}}}}}));
    send(rpc::notification("initialized", Json::object()));
  }

  void send(const std::string& body) {
    auto bytes = rpc::frame(body);
    while (!bytes.empty() && !ended) bytes.erase(0, exchange(bytes));
  }

  /// The next accepted notification of this method; null if the server ends.
  template <class Pleases> Json notified(const std::string& method, Pleases pleases) {
    while (true) {
      while (auto next = frames.next()) {
        auto message = Json::parse(std::get<std::string>(*next));
        if (message.value("method", "") == method && pleases(message["params"]))
          return message["params"];
      }
      if (ended) return nullptr;
      exchange("");
    }
  }

  /// The processes that it has started.
  std::vector<int> children() const {
    std::vector<int> all;
    const auto tasks = "/proc/" + std::to_string(child.id()) + "/task";
    for (const auto& task : std::filesystem::directory_iterator(tasks)) {
      std::ifstream list(task.path() / "children");
      for (int id = 0; list >> id;) all.push_back(id);
    }
    return all;
  }

  [[nodiscard]] int id() const { return child.id(); }
  std::string ending() {
    while (!ended) exchange("");
    return child.ending();
  }

private:
  static process::Child started() {
    auto made = process::Child::start({PROSKILL_PROGRAM, "lsp", "--no-cache"});
    REQUIRE(made);
    return std::move(*made);
  }

  std::size_t exchange(std::string_view bytes) {
    auto done = child.exchange(bytes, std::chrono::milliseconds(1000));
    frames.feed(done.received);
    ended = done.ended;
    return done.sent;
  }

  process::Child child;
  rpc::FrameReader frames;
  bool ended = false;
};

/// Whether a process has ended; waits up to a minute.
bool ends(int process) {
  for (int i = 0; i < 6000; ++i) {
    std::ifstream status("/proc/" + std::to_string(process) + "/stat");
    std::string id;
    std::string name;
    std::string state;
    if (!(status >> id >> name >> state) || state == "Z") return true;
    poll(nullptr, 0, 10);
  }
  return false;
}

int verifyingProcess(ServerProcess& server) {
  server.send(rpc::notification("textDocument/didOpen", {{"textDocument",
                                                          {{"uri", "file:///w/many.proskill"},
                                                           {"languageId", "proskill"},
                                                           {"version", 1},
                                                           {"text", test::endlessProgram()}}}}));
  auto news = server.notified("proskill/verdicts",
                              [](const Json& it) { return it["progress"].is_object(); });
  REQUIRE(news.is_object());
  CHECK(news["progress"]["classes"] > 0);
  const auto children = server.children();
  REQUIRE(children.size() == 1);
  return children.front();
}

} // namespace

TEST_CASE("what verifies ends with the server, however this ends") {
  for (const auto how : {SIGKILL, SIGTERM}) {
    ServerProcess server;
    const int worker = verifyingProcess(server);
    kill(server.id(), how);
    CHECK(server.ending().starts_with("it was ended by signal"));
    CHECK(ends(worker));
  }
  ServerProcess server;
  const int worker = verifyingProcess(server);
  server.send(rpc::request(2, "shutdown", nullptr));
  server.send(rpc::notification("exit", nullptr));
  CHECK(server.ending() == "it ended with exit code 0");
  CHECK(ends(worker));
}

TEST_CASE("an edit ends the verification of the older text") {
  ServerProcess server;
  const int worker = verifyingProcess(server);
  server.send(
      rpc::notification("textDocument/didChange",
                        {{"textDocument", {{"uri", "file:///w/many.proskill"}, {"version", 2}}},
                         {"contentChanges", Json::array({{{"text", "(defsv"}}})}}));
  server.notified("proskill/verdicts", [](const Json& it) { return it["state"] == "errors"; });
  CHECK(ends(worker));
  CHECK(server.children().empty());
}

TEST_CASE("a verification that is killed keeps its verdicts, and leaves the rest open") {
  ServerProcess server;
  kill(verifyingProcess(server), SIGKILL);
  auto news = server.notified("proskill/verdicts", [](const Json& it) {
    return it["state"] == "done" || it["state"] == "failed";
  });
  REQUIRE(news["state"] == "done");
  std::size_t reachable = 0;
  std::size_t open = 0;
  for (const auto& verdict : news["verdicts"]) {
    reachable += verdict["verdict"] == "reachable" ? 1 : 0;
    if (verdict["verdict"] != "inconclusive") continue;
    ++open;
    CHECK(verdict["reason"] ==
          "the process that verifies gave no answer: it was ended by signal 9 (Killed)");
  }
  CHECK(reachable > 0); // each skill can end
  CHECK(open > 0);      // deadlocks are decided last
}

TEST_CASE("verdicts come as they are decided, while the rest is being verified") {
  ServerProcess server;
  verifyingProcess(server);
  const auto news = server.notified("proskill/verdicts", [](const Json& it) {
    return it["state"] != "checking" || it["counts"]["good"] > 0;
  });
  REQUIRE(news.is_object());
  CHECK(news["state"] == "checking");
  CHECK(news["counts"]["pending"] > 0);
  CHECK(news["counts"]["inconclusive"] == 0);
  CHECK(news["stale"] == false);
  for (const auto& verdict : news["verdicts"])
    if (verdict["pending"] == true) CHECK(verdict["verdict"] == "inconclusive");
}
