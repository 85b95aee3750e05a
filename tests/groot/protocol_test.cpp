#include "groot/protocol.h"
#include "tests/groot/watched_run.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <random>

using namespace proskill;
using groot::Parts;
using test::WatchedRun;
using Json = nlohmann::json;

namespace {

constexpr auto kMission = R"(
  (defsv door :states (Open Closed) :init Open :transitions :all)
  (defsv n :min 1 :max 3 :init 2)
  (defskill fly :action (fly) :success there)
  (defskill search :success found :body ((fly) (set (door Closed)) (success found)))
  (defskill mission :body ((search) (^ 1))))";
constexpr groot::TreeId kId = {'0', '1', '2', '3', '4', '5', '6', '7',
                               '8', '9', 'a', 'b', 'c', 'd', 'e', 'f'};

std::string head(char letter) { return std::string("\2") + letter + "\x78\x56\x34\x12"; }

/// Requests to a run that has ended.
struct Answering {
  explicit Answering(const std::string& text)
      : it(text),
        breakpoints(it.tree, *it.executable, &pause),
        hooks(it.tree.size(), breakpoints, "", [](groot::Uid) {}),
        protocol(it.tree, *it.executable, hooks, kId) {}
  void run() {
    std::uint64_t time = 1'000;
    it.run([&](const auto&, auto, const auto& state) {
      protocol.follow(state.data(), {.time = ++time});
    });
  }
  Parts ask(const Parts& parts) { return protocol.answer(parts, 1'000, 77); }

  WatchedRun it;
  runtime::Pause pause;
  groot::Breakpoints breakpoints;
  groot::Hooks hooks;
  groot::Protocol protocol;
};

} // namespace

TEST_CASE("a reply repeats the head of its request and adds the id of the tree") {
  Answering of(kMission);
  const auto tree = of.ask({head('T')});
  REQUIRE(tree.size() == 2);
  CHECK(tree[0] == head('T') + "0123456789abcdef");
  CHECK(tree[1] == groot::xmlOf(of.it.tree));
  CHECK(of.ask({"\1T1234"})[0].front() == '\2'); // our version, for viewers with another
}

TEST_CASE("statuses are three bytes a node") {
  Answering of(kMission);
  CHECK(of.ask({head('S')})[1].substr(0, 6) == std::string("\1\0\0\2\0\0", 6));
  of.run();
  const auto ended = of.ask({head('S')})[1];
  CHECK(ended.size() == 3 * of.it.tree.size());
  CHECK(ended.substr(0, 6) == std::string("\1\0\2\2\0\x0c", 6));
}

TEST_CASE("the root's blackboard has all variables, another one the fields of its skill") {
  Answering of(kMission);
  of.run();
  const auto boards = Json::from_msgpack(of.ask({head('B'), "mission;search::2;nobody"})[1]);
  CHECK(boards.size() == 2);
  CHECK(boards["mission"]["door"] == "Closed");
  CHECK(boards["mission"]["n"] == 2);
  CHECK(boards["search::2"]["status"] == "success");
  CHECK(!boards["search::2"].contains("door"));
  CHECK(Json::from_msgpack(of.ask({head('B'), ""})[1]) == Json::object());
}

TEST_CASE("a recording has the changes since its start, nine bytes each, until they are fetched") {
  Answering of(kMission);
  CHECK(of.ask({head('t')})[1].empty());
  CHECK(of.ask({head('r'), "start"})[1] == "77");
  of.run();
  const auto changes = of.ask({head('t')})[1];
  REQUIRE(changes.size() % 9 == 0);
  CHECK(changes.size() >= 9 * 12);
  CHECK(changes.substr(0, 9) == std::string("\1\0\0\0\0\0\1\0\1", 9)); // 1 µs later the root runs
  CHECK(of.ask({head('t')})[1].empty());
  CHECK(of.ask({head('r'), "stop"}).size() == 1);
}

TEST_CASE("a recording keeps the last 1000 changes") {
  Answering of("(defskill mission :body ((while true (^ 1))))");
  CHECK(of.ask({head('r'), "start"}).size() == 2);
  of.run();
  const auto changes = of.ask({head('t')})[1];
  CHECK(changes.size() == 9 * 1000);
  CHECK(changes.substr(0, 6) != std::string("\1\0\0\0\0\0", 6));
}

TEST_CASE("breakpoints are set, listed, disabled and removed by requests") {
  Answering of(kMission);
  const std::string text = R"({"uid":2,"position":0,"mode":0,"enabled":true,"once":false,)"
                           R"("desired_status":"SKIPPED"})";
  const auto listed = [&] { return Json::parse(of.ask({head('D')}).at(1)); };
  CHECK(listed().empty());
  CHECK(of.ask({head('I'), text}).size() == 1);
  CHECK(listed() == Json::array({Json::parse(text)}));
  CHECK(of.ask({head('X')}).size() == 1);
  CHECK(listed()[0]["enabled"] == false);
  CHECK(of.ask({head('R'), text}).size() == 1);
  CHECK(listed().empty());
  CHECK(of.ask({head('I'), text}).size() == 1);
  CHECK(of.ask({head('A')}).size() == 1);
  CHECK(listed().empty());
  for (const char letter : {'R', 'U'})
    CHECK(of.ask({head(letter), text}) == Parts{"error", "Node ID not found"});
}

TEST_CASE("subscribers get the uid of the node at which the run has stopped") {
  CHECK(groot::Protocol::stopMessage(513, 0x01020304) == Parts{"\2N\4\3\2\1", "513"});
}

TEST_CASE("what is no request gets an error as its reply") {
  Answering of(kMission);
  const auto error = [&](const Parts& parts) {
    const auto reply = of.ask(parts);
    return reply.size() == 2 && reply[0] == "error" ? reply[1] : "";
  };
  CHECK(error({}) == "wrong request header");
  CHECK(error({""}) == "wrong request header");
  CHECK(error({head('T') + "x"}) == "wrong request header");
  CHECK(error({head('Q')}) == "Request not recognized");
  CHECK(error({head('N')}) == "Request not recognized");
  CHECK(error({head('B')}) == "must be 2 parts message");
  CHECK(error({head('B'), "mission", "mission"}) == "must be 2 parts message");
  CHECK(error({head('r')}) == "must be 2 parts message");
  for (const char letter : {'I', 'R', 'U'}) {
    CHECK(error({head(letter)}) == "must be 2 parts message");
    CHECK(error({head(letter), "nonsense"}) == "the second part is not JSON");
  }
  CHECK(error({head('r'), "begin"}) == "neither `start` nor `stop`");
}

TEST_CASE("random bytes get a reply of one or two parts") {
  Answering of(kMission);
  std::mt19937 random(1);
  const std::string letters = "TSBIRNUDAXrt;";
  const auto bytes = [&](std::size_t most) {
    std::string text(random() % (most + 1), '\0');
    for (auto& byte : text) byte = static_cast<char>(random());
    return text;
  };
  std::size_t errors = 0;
  for (int i = 0; i < 20'000; ++i) {
    Parts parts{random() % 2 == 0 ? bytes(8) : head(letters[random() % letters.size()])};
    for (auto more = random() % 3; more > 0; --more) parts.push_back(bytes(20));
    const auto reply = of.ask(parts);
    REQUIRE((reply.size() == 1 || reply.size() == 2));
    errors += reply.front() == "error" ? 1 : 0;
  }
  CHECK(errors > 5'000);
  CHECK(errors < 20'000);
}

TEST_CASE("ids of trees are different UUIDs") {
  const auto id = groot::randomTreeId();
  CHECK(id != groot::randomTreeId());
  CHECK(id[6] >> 4 == 4);
  CHECK(id[8] >> 6 == 2);
}
