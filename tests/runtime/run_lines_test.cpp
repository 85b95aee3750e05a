#include "report/report_json.h"
#include "report/run/run_json.h"
#include "report/run/run_lines.h"
#include "runtime/executor/description.h"
#include "runtime/platform/simulated.h"
#include "tests/support/texts.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

using namespace proskill;
using report::RunLines;
using runtime::Nanoseconds;

namespace {

/// Compares each line with what the general writer of traces makes of the same step.
class LineComparison final : public runtime::Observer {
public:
  explicit LineComparison(report::RunSubject of) : subject(of), lines(of) {}

  void onStep(const runtime::Machine& machine, verify::TransitionId step, Nanoseconds date,
              Nanoseconds lag) override {
    auto expected =
        report::stepJson(subject.program, runStep(subject, machine, step, date, before));
    const auto stops = runtime::stoppingAction(subject.executable, machine);
    if (stops) expected["stops"] = subject.executable.model.performed[*stops].skill;
    stopped += stops ? 1 : 0;
    if (const auto message = runtime::printedMessage(subject.executable, machine))
      expected["message"] = *message;
    compare(lines.step(machine, step, date, lag), expected, date);
  }

  void onRemark(const runtime::Remark& remark) override {
    auto expected = report::stepJson(subject.program, runStep(subject, remark, before));
    expected["remark"] = report::toString(remark.kind);
    if (remark.start) expected["run"] = remark.start->run;
    if (remark.start && remark.start->call)
      expected["action"] = {{"command", remark.start->call->command},
                            {"arguments", remark.start->call->arguments}};
    compare(lines.remark(remark), expected, remark.date);
  }

  std::size_t compared = 0;
  std::size_t stopped = 0;

private:
  void compare(std::string_view line, const OrderedJson& expected, Nanoseconds date) {
    const auto made = OrderedJson::parse(line);
    if (nlohmann::json(made) != nlohmann::json(expected)) {
      INFO(line << "\n" << expected.dump());
      CHECK(false);
    }
    before = date;
    ++compared;
  }

  report::RunSubject subject;
  RunLines lines;
  Nanoseconds before = 0;
};

} // namespace

TEST_CASE("a recorded line says what a trace says of the same step") {
  std::size_t stopped = 0;
  for (const std::string name :
       {"docs/tour/dock", "examples/drone/drone", "docs/tour/constructs"}) {
    std::ifstream file(std::string(PROSKILL_SOURCE_DIR) + "/" + name + ".proskill");
    std::stringstream text;
    text << file.rdbuf();
    const auto program = test::programOfText(text.str());
    const auto executable = runtime::makeExecutable(program, "", false);
    INFO(name);
    REQUIRE(executable);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const auto clock = runtime::simulatedClock();
      auto settings = defaultSettings(**executable);
      for (std::size_t i = 0; i < settings.signals.size(); ++i)
        settings.signals[i] = runtime::Span{runtime::kSecond, 9 * runtime::kSecond};
      for (auto& action : settings.actions) action.stops = {0, runtime::kSecond};
      const auto platform = simulatedPlatform(std::move(settings), seed);
      LineComparison run({program, **executable});
      std::ignore = execute(**executable, *clock, *platform, run,
                            {.seed = seed, .until = 100 * runtime::kSecond});
      CHECK(run.compared > 3);
      stopped += run.stopped;
    }
  }
  CHECK(stopped > 0);
}
