// Measures execution in simulated time; runtime_real.cpp measures it in real time.

#include "bench/runtime.h"
#include "bench/measure.h"
#include "bench/programs.h"
#include "report/run/run_report.h"
#include "runtime/platform/simulated.h"
#include "tests/support/texts.h"

#include <fmt/format.h>

#include <fstream>
#include <unistd.h>

using namespace proskill;
using namespace proskill::bench;
using runtime::Nanoseconds;

namespace {

runtime::RunResult simulate(const runtime::Executable& executable, runtime::Observer& observer,
                            Nanoseconds until) {
  const auto clock = runtime::simulatedClock();
  const auto platform = simulatedPlatform(defaultSettings(executable), 1);
  return execute(executable, *clock, *platform, observer, {.until = until});
}

/// A mission without end: two parallel actions, a wait, a decision.
constexpr std::string_view kEndless = R"(
  (defsv motors :states (Off On) :init Off :transitions :all)
  (defskill fly :start (motors On) :time_interval [2,5] :action (fly) :interrupt (:effects (motors Off))
    :success there (:effects (motors Off)) :failure lost)
  (defskill look :time_interval [1,2] :action (look) :success seen :failure nothing)
  (defskill mission :body ((while true (// ((fly)) ((look) (^ 0.5))) (if (= look.status success) (^ 1) else (^ 2))))))";

constexpr Nanoseconds kHour = 3600 * runtime::kSecond;
constexpr Nanoseconds kDay = 24 * kHour;

long residentKiB() {
  std::ifstream status("/proc/self/statm");
  long all = 0;
  long resident = 0;
  status >> all >> resident;
  return resident * (sysconf(_SC_PAGESIZE) / 1024);
}

void measureSimulation() {
  const auto mission = test::programOfText(drone());
  const auto flying = executableOf(mission);
  const auto endlessProgram = test::programOfText(std::string(kEndless));
  const auto endless = executableOf(endlessProgram);
  Deaf deaf;
  Table table("Simulated time");
  constexpr int kMissions = 2'000;
  std::uint64_t steps = 0;
  const double missions = medianSeconds(
      [&] {
        steps = 0;
        for (int i = 0; i < kMissions; ++i) steps += simulate(*flying, deaf, kDay).steps;
      },
      3);
  table.add({"the drone's mission, again and again",
             rate(static_cast<double>(steps) / missions, "steps"),
             duration(missions / kMissions) + " a mission", 0});
  std::uint64_t many = 0;
  const double day = medianSeconds([&] { many = simulate(*endless, deaf, kDay).steps; }, 3);
  table.add({"24 h of a mission without end", rate(static_cast<double>(many) / day, "steps"),
             duration(day / static_cast<double>(many)) + " a step", 0});
  std::size_t bytes = 0;
  std::uint64_t few = 0;
  const double plain = medianSeconds([&] { few = simulate(*endless, deaf, kHour).steps; });
  const double recorded = medianSeconds(
      [&] {
        bytes = 0;
        const auto recording = report::runRecording(
            [&](std::string_view added, std::string_view) { bytes += added.size(); },
            {endlessProgram, *endless});
        keep(simulate(*endless, *recording, kHour).steps);
      },
      3);
  table.add({"an hour of it with a recording, to memory", duration(recorded),
             "without " + duration(plain), recorded / plain});
  table.add({"", duration((recorded - plain) / static_cast<double>(few)) + " a step",
             fmt::format("{} bytes a step", bytes / few), 0});
  std::size_t mcapBytes = 0;
  const double inMcap = medianSeconds(
      [&] {
        mcapBytes = 0;
        const auto recording = report::runMcap(
            {[&](std::string_view added, std::string_view) { mcapBytes += added.size(); },
             [](std::uint64_t, std::string_view) {}},
            {endlessProgram, *endless}, 0);
        keep(simulate(*endless, *recording, kHour).steps);
      },
      3);
  table.add({"the same in MCAP", duration((inMcap - plain) / static_cast<double>(few)) + " a step",
             fmt::format("{} bytes a step", mcapBytes / few), inMcap / plain});
  const auto before = residentKiB();
  keep(simulate(*endless, deaf, 10 * kDay).steps);
  table.add({"memory, grown in 240 h", fmt::format("{} kB", residentKiB() - before), "", 0});
  const auto recording = report::runMcap(
      {[](std::string_view, std::string_view) {}, [](std::uint64_t, std::string_view) {}},
      {endlessProgram, *endless}, 0);
  keep(simulate(*endless, *recording, kHour).steps);
  const auto after = residentKiB();
  keep(simulate(*endless, *recording, kDay).steps);
  table.add({"memory, grown in 24 h with a recording", fmt::format("{} kB", residentKiB() - after),
             "", 0});
}

} // namespace

int main() {
  measureSimulation();
  measureRealTime();
}
