#include "groot/log.h"
#include "groot/monitor.h"
#include "report/run/run_report.h"
#include "runtime/control/signal_inbox.h"
#include "runtime/platform/process.h"
#include "runtime/platform/simulated.h"
#include "tests/runtime/run_of.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <dlfcn.h>
#include <mutex>
#include <new>
#include <poll.h>
#include <pthread.h>

using namespace proskill;

namespace {

thread_local bool counts = false; ///< of the thread that takes the steps
std::size_t allocations = 0;
std::size_t locks = 0;

void* allocated(std::size_t size) {
  if (counts) ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

} // namespace

// Replaces the global operators, to count allocations of libraries, too.
void* operator new(std::size_t size) { return allocated(size); }
void* operator new[](std::size_t size) { return allocated(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

// Replaces the function of the C library, to count the locks of std::mutex.
extern "C" int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  using Lock = int (*)(pthread_mutex_t*);
  static const auto lock = std::bit_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  if (counts) ++locks;
  return lock(mutex);
}

namespace {

/// Counts allocations and locks between two steps.
class Counter final : public runtime::Observer {
public:
  Counter(std::uint64_t from, std::uint64_t to) : first(from), last(to) {
    expectToCount();
    allocations = 0;
    locks = 0;
  }
  ~Counter() override { counts = false; }

  void onStep(const runtime::Machine&, verify::TransitionId, runtime::Nanoseconds,
              runtime::Nanoseconds) override {
    ++steps;
    counts = steps >= first && steps < last;
  }
  void onRemark(const runtime::Remark& remark) override {
    ++remarks[static_cast<std::size_t>(remark.kind)];
  }

  const std::uint64_t first;
  const std::uint64_t last;
  std::uint64_t steps = 0;
  std::array<std::uint64_t, 10> remarks{};

private:
  static void expectToCount() {
    counts = true;
    ::operator delete(::operator new(1));
    std::mutex mutex;
    const std::lock_guard lock(mutex);
    counts = false;
    REQUIRE(allocations > 0);
    REQUIRE(locks > 0);
  }
};

} // namespace

namespace {

constexpr auto kPatrolling = R"(
    (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
    (defsv motors :states (Off On) :init Off :transitions :all)
    (defsv loads :min 0 :max 3 :init 0)
    (defevent storm :effects (sky Stormy))
    (defevent clears :effects (sky Clear))
    (defskill fly :start (motors On) :invariant (calm (:guard (sky Clear) :effects (motors Off)))
      :time_interval [2,5] :action (fly) :interrupt (:effects (motors Off))
      :success there (:effects (motors Off)) :failure lost)
    (defskill load :input ($what string) :time_interval [1,2] :action (load $what)
      :success loaded (:effects (loads 2)) :failure dropped)
    (defskill mission :body (
      (while true
        (// ((fly)) ((load what "a") (^ [0.5,1]) (fly.interrupt)))
        (case (load what "b") ((success loaded) (^ 1)) (else (^ 2)))))))";

/// Passes a run on to a recording, and then counts.
class Recorded final : public runtime::Observer {
public:
  Recorded(Counter& of, std::unique_ptr<runtime::Observer> to)
      : counter(of), recording(std::move(to)) {}
  void onStep(const runtime::Machine& machine, verify::TransitionId step, runtime::Nanoseconds date,
              runtime::Nanoseconds lag) override {
    recording->onStep(machine, step, date, lag);
    counter.onStep(machine, step, date, lag);
  }
  void onRemark(const runtime::Remark& remark) override {
    recording->onRemark(remark);
    counter.onRemark(remark);
  }

private:
  Counter& counter;
  std::unique_ptr<runtime::Observer> recording;
};

/// Runs with everything that `--view` adds to the run itself.
void patrol(const runtime::Executable& executable, runtime::Observer& observer) {
  runtime::Pause pause;
  runtime::SignalInbox inbox(pause.wakeUp);
  const auto clock = pausableClock(runtime::simulatedClock(), pause);
  const auto simulated = simulatedPlatform(defaultSettings(executable), 1);
  const auto platform = withInbox(*simulated, inbox, false);
  const runtime::RunOptions options{.until = 1'000'000 * runtime::kSecond, .pause = &pause};
  CHECK(execute(executable, *clock, *platform, observer, options).end == runtime::End::Until);
  counts = false;
}

} // namespace

TEST_CASE("no step of a run allocates memory or takes a lock after the start") {
  const auto executable = test::executableOf(kPatrolling, false);
  Counter counter(2'000, 50'000);
  patrol(*executable, counter);
  CHECK(counter.steps > counter.last);
  using runtime::RemarkKind;
  for (const auto kind : {RemarkKind::Started, RemarkKind::Asked, RemarkKind::GuardFailed})
    CHECK(counter.remarks[static_cast<std::size_t>(kind)] > 100);
  CHECK(allocations == 0);
  CHECK(locks == 0);
}

TEST_CASE("a recording and a page allocate no memory and take no lock in a step, MCAP but for each "
          "chunk") {
  const auto program = test::programOfText(kPatrolling);
  const auto executable = runtime::makeExecutable(program, "", false);
  REQUIRE(executable);
  const report::RunSubject subject{program, **executable};
  const auto append = [](std::string_view, std::string_view) {};
  std::size_t chunks = 0;
  const auto replace = [&](std::uint64_t, std::string_view) { ++chunks; };
  const auto allocated = [&](std::unique_ptr<runtime::Observer> recording) {
    Counter counter(10'000, 50'000);
    Recorded recorded(counter, std::move(recording));
    patrol(**executable, recorded);
    CHECK(counter.steps > counter.last);
    CHECK(locks == 0);
    return allocations;
  };
  CHECK(allocated(report::runRecording(append, subject)) == 0);
  CHECK(allocated(report::runLive([](std::string_view) { return true; }, subject)) == 0);
  const auto forChunks = allocated(report::runMcap({append, replace}, subject, 0));
  CHECK(forChunks < 10 * chunks);
  CHECK(chunks > 5);
}

namespace {

/// No viewer ever comes.
class NoViewers final : public groot::Sockets {
public:
  [[nodiscard]] std::uint16_t port() const override { return 0; }
  void wait(int descriptor, long milliseconds) override {
    pollfd watched{descriptor, POLLIN, 0};
    ::poll(&watched, 1, static_cast<int>(milliseconds));
  }
  [[nodiscard]] std::optional<std::vector<std::string>> receive() override { return std::nullopt; }
  void reply(const std::vector<std::string>&) override {}
  void publish(const std::vector<std::string>&) override {}
};

/// Looks whether a run has come to a breakpoint.
class Looking final : public runtime::Observer {
public:
  explicit Looking(groot::Breakpoints& of) : breakpoints(of) {}
  void onStep(const runtime::Machine& machine, verify::TransitionId, runtime::Nanoseconds,
              runtime::Nanoseconds) override {
    breakpoints.follow(machine);
  }
  void onRemark(const runtime::Remark&) override {}

private:
  groot::Breakpoints& breakpoints;
};

} // namespace

TEST_CASE("viewers of behavior trees, their breakpoints and logs allocate no memory and take no "
          "lock in a step") {
  const auto program = test::programOfText(kPatrolling);
  const auto executable = runtime::makeExecutable(program, "", false);
  REQUIRE(executable);
  const auto tree = groot::treeOf(program, **executable);
  REQUIRE(tree);
  const auto allocated = [&](std::unique_ptr<runtime::Observer> observer) {
    Counter counter(2'000, 50'000);
    Recorded recorded(counter, std::move(observer));
    patrol(**executable, recorded);
    CHECK(counter.steps > counter.last);
    CHECK(locks == 0);
    return allocations;
  };
  CHECK(allocated(groot::logOf(
            *tree, **executable, [](std::string_view) {}, 0)) == 0);
  groot::Monitor monitor(*tree, **executable, std::make_unique<NoViewers>(), true, {});
  CHECK(allocated(monitor.observer()) == 0);
  runtime::Pause pause;
  groot::Breakpoints breakpoints(*tree, **executable, &pause);
  breakpoints.set(1, groot::Position::Post, true); // the end of the mission, which never comes
  CHECK(allocated(std::make_unique<Looking>(breakpoints)) == 0);
  CHECK_FALSE(pause.isHeld());
}

TEST_CASE("no step with a program as its platform takes a lock") {
  const auto executable = test::executableOf(R"(
    (defskill fly :action (fly 3 "there" -0.5) :success there :failure lost)
    (defskill look :action (look) :interrupt () :success seen)
    (defskill mission :body (
      (while true (// ((fly) (^ 0.0001) (look.interrupt)) ((look)))))))",
                                             false);
  // flies at once, and looks until it is asked to stop
  constexpr auto kRobot = R"(
    read -r hello; echo '{"type":"ready","protocol":1}'
    while read -r line; do
      run="${line#*\"run\":}"; run="${run%%[,\}]*}"
      case "$line" in
        *'"end"'*) exit 0;;
        *'"fly"'*) echo '{"type":"result","run":'"$run"',"result":"there"}';;
        *'"stop"'*) echo '{"type":"stopped","run":'"$run"'}';;
      esac
    done)";
  const auto platform = runtime::processPlatform(
      *executable, {.command = {"/bin/sh", "-c", kRobot}, .directory = "/"}, [] { return false; });
  REQUIRE(platform);
  std::atomic<int> requests = 0;
  class UntilStep final : public runtime::Observer {
  public:
    UntilStep(Counter& of, std::atomic<int>& ending) : counter(of), requests(ending) {}
    void onStep(const runtime::Machine& machine, verify::TransitionId step,
                runtime::Nanoseconds date, runtime::Nanoseconds lag) override {
      counter.onStep(machine, step, date, lag);
      if (counter.steps == counter.last) ++requests;
    }
    void onRemark(const runtime::Remark& remark) override { counter.onRemark(remark); }

  private:
    Counter& counter;
    std::atomic<int>& requests;
  };
  Counter counter(200, 2'000);
  UntilStep observer(counter, requests);
  const auto clock = runtime::realClock();
  const auto result =
      execute(*executable, *clock, **platform, observer, {.stopRequests = &requests});
  CHECK(result.end == runtime::End::Stopped);
  CHECK(result.bad == 0);
  CHECK(locks == 0);
}
