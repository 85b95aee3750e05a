#include "view/run_panel.h"

#include "report/run/run_report.h"
#include "report/sources.h"
#include "runtime/platform/simulated.h"
#include "tests/support/run.h"
#include "tests/support/texts.h"
#include "view/panel_data.h"
#include "view/panel_routes.h"

#include <catch2/catch.hpp>

#include <future>
#include <map>

using namespace proskill;

namespace {

const std::string kDoor = R"(
  (defsv door :states (Open Closed) :init Open :transitions :all)
  (defevent door_closes :effects (door Closed))
  (defskill drive :time_interval [1,2] :action (drive) :interruptible t :success there)
  (defskill mission :success done :body ((drive) (^ 1) (drive) (success done))))";

/// A run with its page, without a server: requests are answered in this process.
class Page {
public:
  explicit Page(std::string whyNoControl = "", std::string whyNoPause = "")
      : program(test::programOfText(kDoor)),
        executable(std::move(*runtime::makeExecutable(program, "", false))),
        panel({program, *executable, pause, inbox, std::nullopt, std::move(whyNoControl),
               std::move(whyNoPause), [this] { ++asked; }},
              news) {}

  ~Page() { news.close(); }

  /// Runs the program to its end in simulated time.
  runtime::RunResult run() {
    const auto observer =
        report::runLive([this](auto line) { return panel.push(line); }, {program, *executable});
    const auto clock = pausableClock(runtime::simulatedClock(), pause);
    const auto simulated = simulatedPlatform(defaultSettings(*executable), 1);
    const auto platform = withInbox(*simulated, inbox, false);
    auto result = execute(*executable, *clock, *platform, *observer,
                          {.until = 100 * runtime::kSecond, .pause = &pause});
    panel.finish(result);
    return result;
  }

  view::HttpResponse request(const std::string& path, const OrderedJson& body,
                             const std::map<std::string, std::string>& headers = {}) {
    view::HttpRequest request{"POST",
                              path,
                              {{"host", "127.0.0.1:80"}, {"content-type", "application/json"}},
                              body.dump()};
    for (const auto& [name, value] : headers) request.headers[name] = value;
    std::promise<view::HttpResponse> promise;
    answer(request, {80, "secret"}, panel, news,
           [&](view::HttpResponse response) { promise.set_value(std::move(response)); });
    return promise.get_future().get();
  }

  OrderedJson call(const std::string& method, const OrderedJson& params = OrderedJson::object()) {
    const auto response = request("/secret/api/" + method, params);
    REQUIRE(response.status == 200);
    return OrderedJson::parse(response.body);
  }

  OrderedJson control(const std::string& action, const std::string& signal = "") {
    return call("control", {{"do", action}, {"signal", signal}});
  }

  const analysis::Program program;
  const std::unique_ptr<const runtime::Executable> executable;
  runtime::Pause pause;
  runtime::SignalInbox inbox{pause.wakeUp};
  view::EventFeed news;
  int asked = 0;
  view::RunPanel panel;
};

} // namespace

TEST_CASE("a recording that was cut off within a write is shown up to its last step") {
  const std::string head = R"({"name":"run","verdict":"recorded","initial":{},"steps":[)";
  const std::string step = R"({"actor":"drive","description":"starts","location":null})";
  const auto whole = head + "\n" + step + ",\n" + step + ",\n" + step;
  for (std::size_t length = whole.size() - step.size() - 1; length < whole.size(); ++length) {
    INFO(length);
    const auto data = view::savedReport("run.json", whole.substr(0, length));
    REQUIRE(data);
    CHECK((*data)->program()["properties"][0]["steps"] == 2);
  }
  CHECK_FALSE(view::savedReport("run.json", whole.substr(0, head.size() / 2)));
}

TEST_CASE("a saved trace is for an older text once a file of its program is edited") {
  const test::TemporaryDirectory directory;
  const auto file = directory.write("drive.proskill", "(defskill drive)");
  const auto isOlder = [&](const OrderedJson& sources, bool isInReport) {
    const OrderedJson trace{{"name", "p"},
                            {"sources", sources},
                            {"initial", OrderedJson::object()},
                            {"steps", OrderedJson::array()}};
    const OrderedJson property{{"name", "p"}, {"verdict", "violated"}, {"trace", trace}};
    const OrderedJson report{{"properties", OrderedJson::array({property})}};
    const auto data = view::savedReport("saved.json", (isInReport ? report : trace).dump());
    REQUIRE(data);
    return (*data)->trace("p")->value("stale", false);
  };
  for (const bool isInReport : {false, true}) {
    CHECK_FALSE(isOlder({{file, report::sourceDigest("(defskill drive)")}}, isInReport));
    CHECK(isOlder({{file, report::sourceDigest("(defskill  drive)")}}, isInReport));
    CHECK_FALSE(isOlder(nullptr, isInReport)); // of an older `proskill`
  }
}

TEST_CASE("a page gets the steps of a run in parts, and its end") {
  Page page;
  const auto hello = page.call("hello")["result"];
  CHECK(hello["run"]["status"]["state"] == "running");
  CHECK(hello["run"]["trace"]["steps"].empty());
  CHECK(hello["run"]["clock"] == "simulated time");
  const auto result = page.run();
  const auto all = page.call("steps", {{"from", 0}})["result"];
  const auto total = all["total"].get<std::size_t>();
  CHECK(all["steps"].size() == total);
  CHECK(total > result.steps); // with remarks
  const auto rest = page.call("steps", {{"from", total - 3}})["result"];
  CHECK(rest["from"] == total - 3);
  CHECK(rest["steps"].size() == 3);
  CHECK(rest["steps"][2] == all["steps"][total - 1]);
  CHECK(page.call("steps", {{"from", total + 5}})["result"]["steps"].empty());
  CHECK(page.call("trace", {{"name", "run"}})["result"]["steps"] == all["steps"]);
  const auto last = page.call("news", {{"after", 0}})["result"]["news"].back()["params"];
  CHECK(last["state"] == "ended");
  CHECK(last["steps"] == total);
  CHECK(last["end"]["mission"] == "success");
}

TEST_CASE(
    "the steps of a run that nobody reads are kept up to a limit, with the values before them") {
  Page page;
  constexpr std::size_t kMore = 100'500;
  for (std::size_t i = 0; i < kMore; ++i)
    page.panel.push(R"({"changes":[{"variable":"door","before":"Open","after":"v)" +
                    std::to_string(i) + R"("}]})");
  page.panel.finish({});
  const auto answer = page.call("steps", {{"from", 0}})["result"];
  const auto from = answer["from"].get<std::size_t>();
  CHECK(answer["total"] == kMore);
  CHECK(from == 500);
  CHECK(answer["initial"]["door"] == "v" + std::to_string(from - 1));
  CHECK(answer["steps"].size() == 2000); // the rest comes with the next request
  CHECK_FALSE(page.call("steps", {{"from", from}})["result"].contains("initial"));
}

TEST_CASE("controls are accepted from the run's own pages only") {
  Page page;
  const OrderedJson pause{{"do", "pause"}};
  CHECK(page.request("/wrong/api/control", pause).status == 403);
  CHECK(page.request("/api/control", pause).status == 403);
  CHECK(page.request("/secret/api/control", pause, {{"origin", "http://elsewhere"}}).status == 403);
  CHECK(page.request("/secret/api/control", pause, {{"host", "elsewhere:80"}}).status == 403);
  CHECK(page.request("/secret/api/control", pause, {{"content-type", "text/plain"}}).status == 400);
  CHECK(page.request("/secret/api/control", {{"do", 7}}).status == 400);
  CHECK_FALSE(page.pause.isHeld());
  CHECK(page.control("pause")["result"]["state"] == "paused");
  CHECK(page.pause.isHeld());
  CHECK(page.control("continue")["result"]["state"] == "running");
}

TEST_CASE("controls that are not possible say why, and do nothing") {
  Page page;
  CHECK(page.control("fly")["error"] == "there is no such control");
  CHECK(page.control("step")["error"] == "only a paused run takes single steps");
  CHECK(page.control("close")["error"] == "the run has not ended");
  CHECK(page.control("send", "rain").contains("error"));
  CHECK(page.control("send", "door_closes")["result"]["waiting"] == 1);
  CHECK(page.control("send", "drive")["result"]["waiting"] == 2);
  page.run();
  CHECK(page.control("pause")["error"] == "the run has ended");
  CHECK(page.asked == 0);
  CHECK(page.control("close").contains("result"));
  CHECK(page.asked == 1);
}

TEST_CASE("a run that must not be influenced refuses all controls until its end") {
  Page page("no controls");
  for (const auto* action : {"pause", "continue", "step", "end"})
    CHECK(page.control(action)["error"] == "no controls");
  CHECK(page.control("send", "door_closes")["error"] == "no controls");
  CHECK(page.inbox.waiting() == 0);
  page.run();
  CHECK(page.control("close").contains("result"));
}

TEST_CASE("a robot is not paused, but takes events") {
  Page page("", "the robot would go on");
  CHECK(page.control("pause")["error"] == "the robot would go on");
  CHECK(page.control("send", "door_closes")["result"]["waiting"] == 1);
}

TEST_CASE("pages that read all the time change nothing in a run") {
  const auto stepsOf = [](Page& page) {
    page.run();
    return page.call("trace", {{"name", "run"}})["result"]["steps"];
  };
  Page alone;
  const auto expected = stepsOf(alone);
  Page watched;
  std::atomic<bool> ended = false;
  std::vector<std::thread> readers;
  for (int i = 0; i < 2; ++i)
    readers.emplace_back([&] {
      while (!ended) watched.panel.steps({{"from", 0}}).value();
    });
  CHECK(stepsOf(watched) == expected);
  ended = true;
  for (auto& reader : readers) reader.join();
}
