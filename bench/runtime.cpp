// Measures execution: in simulated time, in real time, with a recording, and idle.

#include "bench/measure.h"
#include "report/run/run_report.h"
#include "runtime/executor/executor.h"
#include "runtime/platform/simulated.h"
#include "tests/support/texts.h"
#include "tests/where.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

using namespace proskill;
using namespace proskill::bench;
using runtime::Nanoseconds;

namespace {

double secondsOf(Nanoseconds time) { return static_cast<double>(time) / 1e9; }

Nanoseconds machineTime() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

std::unique_ptr<const runtime::Executable> executableOf(const analysis::Program& program) {
  auto made = runtime::makeExecutable(program, "", true);
  if (made) return std::move(*made);
  fmt::print("{}\n", made.error().message);
  std::exit(1);
}

/// Ignores everything.
class Deaf : public runtime::Observer {
public:
  void onStep(const runtime::Machine&, verify::TransitionId, Nanoseconds, Nanoseconds) override {}
  void onRemark(const runtime::Remark&) override {}
};

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
  std::ifstream file(PROSKILL_SOURCE_DIR "/examples/drone/drone.proskill");
  std::stringstream text;
  text << file.rdbuf();
  const auto drone = test::programOfText(text.str());
  const auto flying = executableOf(drone);
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
  const auto before = residentKiB();
  keep(simulate(*endless, deaf, 10 * kDay).steps);
  table.add({"memory, grown in 240 h", fmt::format("{} kB", residentKiB() - before), "", 0});
}

// --- Real time

/// Reports an event when a descriptor is readable; performs no actions.
class Events final : public runtime::Platform {
public:
  explicit Events(int descriptor) : events(descriptor) {}
  void start(const runtime::Start&, Nanoseconds) override {}
  bool stop(std::uint32_t, runtime::RunNumber, Nanoseconds) override { return true; }
  [[nodiscard]] std::optional<Nanoseconds> next() const override { return {}; }
  bool poll(Nanoseconds date, runtime::Report& report) override {
    std::uint64_t count = 0;
    if (::read(events, &count, sizeof count) <= 0) return false;
    report.kind = runtime::ReportKind::Signal;
    report.date = date;
    report.signal = 0;
    return true;
  }
  [[nodiscard]] bool mayReport() const override { return true; }
  void addDescriptors(std::vector<int>& all) const override { all.push_back(events); }

private:
  int events;
};

/// Records how late steps are, and when they are taken.
class Lateness final : public runtime::Observer {
public:
  void onStep(const runtime::Machine&, verify::TransitionId, Nanoseconds,
              Nanoseconds lag) override {
    last.store(machineTime());
    if (lag > 0) lags.push_back(lag);
  }
  void onRemark(const runtime::Remark&) override {}

  std::atomic<Nanoseconds> last = 0;
  std::vector<Nanoseconds> lags;
};

std::string spread(std::vector<Nanoseconds> all) {
  if (all.empty()) return "nothing";
  std::ranges::sort(all);
  const auto at = [&](double part) {
    return duration(
        secondsOf(all[static_cast<std::size_t>(part * static_cast<double>(all.size() - 1))]));
  };
  return fmt::format("median {}, p99 {}, max {}", at(0.5), at(0.99), at(1));
}

/// Time from the write of an event to the step that a skill takes for it.
void measureEvents(const Table& table) {
  const auto program = test::programOfText(R"(
    (defsv hit :states (No Yes) :init No :transitions :all)
    (defevent touched :effects (hit Yes))
    (defskill react :body ((while true (^ (hit Yes) :effects (hit No))))))");
  auto made = runtime::makeExecutable(program, "", false);
  const int events = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  const int stop = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  std::atomic<int> requests = 0;
  Events platform(events);
  Lateness lateness;
  const auto clock = runtime::realClock();
  std::vector<Nanoseconds> all;
  const std::uint64_t one = 1;
  std::thread writer([&] {
    for (int i = 0; i < 2'000; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      const auto before = lateness.last.load();
      const auto begin = machineTime();
      std::ignore = ::write(events, &one, sizeof one);
      for (int tries = 0; lateness.last.load() == before && tries < 10'000'000; ++tries)
        std::this_thread::yield();
      all.push_back(lateness.last.load() - begin);
    }
    ++requests;
    std::ignore = ::write(stop, &one, sizeof one);
  });
  std::ignore = execute(**made, *clock, platform, lateness,
                        {.stopRequests = &requests, .stopDescriptor = stop});
  writer.join();
  table.add({"from an event to its step", spread(std::move(all)),
             "a loop that polls every 10 ms: median 5 ms", 0});
}

void measureTicks(const Table& table) {
  const auto program = test::programOfText("(defskill tick :body ((while true (^ 0.0001))))");
  const auto executable = executableOf(program);
  Events nothing(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  Lateness lateness;
  lateness.lags.reserve(100'000);
  const auto clock = runtime::realClock();
  std::ignore = execute(*executable, *clock, nothing, lateness, {.until = 3 * runtime::kSecond});
  table.add({"a step every 0.1 ms: late by", spread(lateness.lags), "", 0});
}

void measureIdle(const Table& table) {
  const auto program = test::programOfText("(defskill wait :body ((^ 1000)))");
  const auto executable = executableOf(program);
  Events nothing(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  Deaf deaf;
  const auto clock = runtime::realClock();
  const auto used = [] {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) / 1e6;
  };
  const auto before = used();
  std::ignore = execute(*executable, *clock, nothing, deaf, {.until = 3 * runtime::kSecond});
  table.add({"processor time while nothing happens",
             fmt::format("{:.3f} %", (used() - before) / 3 * 100), "", 0});
}

} // namespace

int main() {
  measureSimulation();
  const Table table("Real time");
  measureEvents(table);
  measureTicks(table);
  measureIdle(table);
}
