// Measures execution in real time: the executor, and beside it the same program in a loop that
// polls every 10 ms.

#include "bench/measure.h"
#include "bench/runtime.h"
#include "record/recorder.h"
#include "report/run/run_report.h"
#include "tests/support/run.h"
#include "tests/support/texts.h"

#include <algorithm>
#include <chrono>
#include <sched.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace proskill::bench {

using runtime::Nanoseconds;

namespace {

constexpr Nanoseconds kPeriod = runtime::kSecond / 100;

double secondsOf(Nanoseconds time) { return static_cast<double>(time) / 1e9; }

Nanoseconds machineTime() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

/// The clock of a loop that looks every 10 ms whether there is something to do.
class PollingClock final : public runtime::Clock {
public:
  void start() override { inner->start(); }
  Nanoseconds now() override { return inner->now(); }
  void wait(std::optional<Nanoseconds>, const std::vector<int>&) override {
    inner->wait((inner->now() / kPeriod + 1) * kPeriod, {});
  }
  [[nodiscard]] bool isReal() const override { return true; }

private:
  std::unique_ptr<runtime::Clock> inner = runtime::realClock();
};

/// Reports an event when a descriptor is readable; performs no actions.
class Events final : public runtime::Platform {
public:
  Events() : events(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}
  Events(const Events&) = delete;
  Events& operator=(const Events&) = delete;
  ~Events() override { ::close(events); }

  void happen() const {
    const std::uint64_t one = 1;
    std::ignore = ::write(events, &one, sizeof one);
  }
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

/// Notes how late steps are, and when the last one was taken.
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

/// Median, 99th percentile and maximum.
struct Spread {
  explicit Spread(std::vector<Nanoseconds> of) : all(std::move(of)) { std::ranges::sort(all); }
  [[nodiscard]] double at(double part) const {
    if (all.empty()) return 0;
    return secondsOf(all[static_cast<std::size_t>(part * static_cast<double>(all.size() - 1))]);
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("median {}, p99 {}, max {}", duration(at(0.5)), duration(at(0.99)),
                       duration(at(1)));
  }

  std::vector<Nanoseconds> all;
};

/// From the write of an event to the step that a skill takes for it.
Spread eventsOf(runtime::Clock& clock, int count) {
  const auto program = test::programOfText(R"(
    (defsv hit :states (No Yes) :init No :transitions :all)
    (defevent touched :effects (hit Yes))
    (defskill react :body ((while true (^ (hit Yes) :effects (hit No))))))");
  const auto executable = executableOf(program, false);
  const int stop = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  std::atomic<int> requests = 0;
  const Events platform;
  Lateness lateness;
  std::vector<Nanoseconds> all;
  std::thread writer([&] {
    for (int i = 0; i < count; ++i) {
      std::this_thread::sleep_for(std::chrono::microseconds(1'000 + 37 * (i % 270)));
      const auto before = lateness.last.load();
      const auto begin = machineTime();
      platform.happen();
      while (lateness.last.load() == before && machineTime() < begin + runtime::kSecond)
        std::this_thread::yield();
      all.push_back(lateness.last.load() - begin);
    }
    ++requests;
    const std::uint64_t one = 1;
    std::ignore = ::write(stop, &one, sizeof one);
  });
  std::ignore = execute(*executable, clock, const_cast<Events&>(platform), lateness,
                        {.stopRequests = &requests, .stopDescriptor = stop});
  writer.join();
  ::close(stop);
  return Spread(std::move(all));
}

void measureEvents(const Table& table) {
  constexpr int kEvents = 1'000;
  constexpr int kPolled = 200;
  const auto clock = runtime::realClock();
  PollingClock polling;
  const auto ours = eventsOf(*clock, kEvents);
  const auto polled = eventsOf(polling, kPolled);
  table.add({"from an event to its step", ours.text(), "polling: " + polled.text(),
             ours.at(0.5) / polled.at(0.5)});
}

/// Threads that occupy every processor while it lives.
class Load {
public:
  explicit Load(bool isOn) {
    for (unsigned i = 0; isOn && i < std::thread::hardware_concurrency(); ++i)
      threads.emplace_back([](const std::stop_token& stop) {
        for (std::size_t n = 0; !stop.stop_requested(); ++n) keep(n);
      });
  }

private:
  std::vector<std::jthread> threads;
};

/// Whether this thread has the class now.
bool setRealtime(bool isOn) {
  const sched_param parameters{.sched_priority = isOn ? 50 : 0};
  return sched_setscheduler(0, isOn ? SCHED_FIFO : SCHED_OTHER, &parameters) == 0;
}

/// How late a step every 0.1 ms is.
void measureTicks(const Table& table) {
  const auto program = test::programOfText("(defskill tick :body ((while true (^ 0.0001))))");
  const auto executable = executableOf(program);
  for (const bool isLoaded : {false, true})
    for (const bool isRealtime : {false, true}) {
      const auto name =
          fmt::format("a step every 0.1 ms{}{}: late by", isLoaded ? ", all processors busy" : "",
                      isRealtime ? ", SCHED_FIFO" : "");
      Events nothing;
      Lateness lateness;
      lateness.lags.reserve(100'000);
      const Load load(isLoaded);
      if (isRealtime && !setRealtime(true)) {
        table.add({name, "SCHED_FIFO was refused", "", 0});
        continue;
      }
      const auto clock = runtime::realClock();
      std::ignore =
          execute(*executable, *clock, nothing, lateness, {.until = 2 * runtime::kSecond});
      setRealtime(false);
      table.add({name, Spread(std::move(lateness.lags)).text(), "", 0});
    }
}

double processorTime() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) / 1e6;
}

/// The part of a processor that a run of 3 s takes.
double processorPart(const runtime::Executable& executable, runtime::Clock& clock,
                     runtime::Observer& observer) {
  constexpr Nanoseconds kTime = 3 * runtime::kSecond;
  Events nothing;
  const auto before = processorTime();
  std::ignore = execute(executable, clock, nothing, observer, {.until = kTime});
  return (processorTime() - before) / secondsOf(kTime);
}

std::string percent(double part) { return fmt::format("{:.3f} %", 100 * part); }

/// The same with a recording to a file, as `--record` writes it.
double recordedPart(const analysis::Program& program, const runtime::Executable& executable) {
  const test::TemporaryDirectory directory;
  record::Recorder recorder(std::move(*disk::GrowingFile::create(directory.path("run.mcap"))),
                            record::RunTime::Real);
  const auto recording = report::runMcap({[&](std::string_view bytes, std::string_view end) {
                                            std::ignore = recorder.add(bytes, end);
                                          },
                                          [&](std::uint64_t at, std::string_view bytes) {
                                            std::ignore = recorder.replace(at, bytes);
                                          }},
                                         {program, executable}, 0);
  const auto clock = runtime::realClock();
  return processorPart(executable, *clock, *recording);
}

void measureProcessor(const Table& table) {
  Deaf deaf;
  PollingClock polling;
  const auto clock = runtime::realClock();
  const auto waiting = test::programOfText("(defskill wait :body ((^ 1000)))");
  const auto idle = executableOf(waiting);
  const auto ours = processorPart(*idle, *clock, deaf);
  const auto polled = processorPart(*idle, polling, deaf);
  table.add({"processor time while nothing happens", percent(ours), "polling: " + percent(polled),
             ours / polled});
  for (const auto* period : {"0.01", "0.0001"}) {
    const auto program =
        test::programOfText(fmt::format("(defskill tick :body ((while true (^ {}))))", period));
    const auto executable = executableOf(program);
    const auto without = processorPart(*executable, *clock, deaf);
    const auto with = recordedPart(program, *executable);
    table.add({fmt::format("processor time of a step every {} s, recorded", period), percent(with),
               "without a recording: " + percent(without), with / without});
  }
}

} // namespace

void measureRealTime() {
  const Table table("Real time");
  measureEvents(table);
  measureTicks(table);
  measureProcessor(table);
}

} // namespace proskill::bench
