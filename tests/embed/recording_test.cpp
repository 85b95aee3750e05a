#include "report/run/read_recording.h"
#include "runtime/conform/conform.h"
#include "tests/embed/embedded.h"
#include "tests/support/recorded.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <fstream>

using namespace proskill;
using Catch::Contains;
using test::Embedded;

namespace {

const std::string kFlies = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill fly :action (fly) :time_interval [1,5] :interrupt () :success there)
  (defskill mission :success done :body ((fly) (^ (sky Stormy)) (fly) (success done))))";

/// A run whose event comes at 10 s.
struct Recorded : Embedded {
  explicit Recorded(proskill_options options = simulated()) : Embedded(kFlies, options) {
    perform("fly", {2, "there"});
  }
  proskill_error record(const std::string& name) const {
    return proskill_executor_record(executor, name.c_str());
  }
  void run() const {
    REQUIRE(proskill_executor_start(executor) == PROSKILL_OK);
    REQUIRE(proskill_executor_report_after(executor, 10, "storm") == PROSKILL_OK);
    REQUIRE(proskill_executor_run(executor) == PROSKILL_OK);
  }
  std::string lacking() const { return proskill_executor_recording_error(executor); }
};

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What the model makes of a recording: its number of steps, or why it is not a run.
std::string judged(const std::string& bytes) {
  const auto program = test::programOfText(kFlies);
  runtime::KeptRun kept;
  if (const auto wrong = report::readRecording(test::fileOf(bytes), program, kept)) return *wrong;
  const auto result = runtime::conform(program, kept.run, {});
  return result && result->why.empty() ? std::to_string(kept.run.steps.size()) : result->why;
}

} // namespace

TEST_CASE("a run of functions is recorded, in MCAP and as a trace") {
  for (const auto* name : {"run.mcap", "run.json"}) {
    const Recorded recorded;
    REQUIRE(recorded.record(recorded.path(name)) == PROSKILL_OK);
    recorded.run();
    CHECK(recorded.lacking() == "");
    CHECK(judged(contentOf(recorded.path(name))) ==
          std::to_string(proskill_executor_steps(recorded.executor)));
    CHECK(proskill_executor_steps(recorded.executor) > 5);
  }
}

TEST_CASE("a recording in real time is complete when the run has ended, or is freed") {
  proskill_options options = PROSKILL_OPTIONS;
  options.speed = 1000;
  const test::TemporaryDirectory files;
  {
    const Recorded recorded(options);
    REQUIRE(recorded.record(files.path("run.mcap")) == PROSKILL_OK);
    recorded.run();
    CHECK(contentOf(files.path("run.mcap")).ends_with("MCAP0\r\n"));
    CHECK_THAT(contentOf(files.path("run.mcap")), Contains("/steps"));
  }
  {
    const Recorded freed;
    REQUIRE(freed.record(files.path("freed.mcap")) == PROSKILL_OK);
    REQUIRE(proskill_executor_start(freed.executor) == PROSKILL_OK);
    REQUIRE(proskill_executor_proceed(freed.executor) == PROSKILL_OK);
  }
  CHECK(judged(contentOf(files.path("freed.mcap"))).find_first_not_of("123456789") ==
        std::string::npos);
}

TEST_CASE("a full disk ends the recording of a run, which goes on with a note") {
  const Recorded recorded;
  REQUIRE(recorded.record("/dev/full") == PROSKILL_OK);
  recorded.run();
  CHECK_THAT(recorded.text(), Contains("No space left on device; the recording ends here"));
  CHECK_THAT(recorded.lacking(), Contains("No space left on device; the recording ends here"));
  CHECK(proskill_executor_faults(recorded.executor) == 0);
  CHECK(std::string(proskill_executor_outcome(recorded.executor)) == "success");
}

TEST_CASE("a recording that cannot begin is an error") {
  const Recorded recorded;
  CHECK(recorded.record("/nowhere/run.mcap") == PROSKILL_UNWRITABLE);
  CHECK_THAT(recorded.error(), Contains("/nowhere/run.mcap"));
  CHECK(recorded.record("run.btlog") == PROSKILL_INVALID_ARGUMENT);
  CHECK(proskill_executor_record(recorded.executor, nullptr) == PROSKILL_INVALID_ARGUMENT);
  REQUIRE(recorded.record(recorded.path("run.mcap")) == PROSKILL_OK);
  CHECK(recorded.record("other.mcap") == PROSKILL_WRONG_ORDER);
  CHECK(recorded.error() == "the run is recorded in `run.mcap`");
  recorded.run();
  CHECK(recorded.record("other.mcap") == PROSKILL_WRONG_ORDER);
}

TEST_CASE("an earlier recording stays until the run starts") {
  const Recorded recorded;
  const auto path = recorded.path("run.json");
  std::ofstream(path) << "earlier";
  REQUIRE(recorded.record(path) == PROSKILL_OK);
  CHECK(contentOf(path) == "earlier");
  recorded.run();
  CHECK(contentOf(path) != "earlier");
}
