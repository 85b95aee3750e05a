#include "runtime/control/byte_queue.h"
#include "runtime/control/signal_inbox.h"
#include "runtime/executor/description.h"
#include "runtime/platform/settings.h"
#include "tests/runtime/run_of.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <thread>

using namespace proskill;
using runtime::End;
using runtime::kSecond;
using runtime::Nanoseconds;

namespace {

const std::string kPatrol = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defevent storm :effects (sky Stormy))
  (defskill fly :time_interval [2,5] :action (fly) :interruptible t :success there :failure lost)
  (defskill mission :success done :failure failed :body ((fly) (^ 1.5) (fly) (success done))))";

/// A run in a thread of its own, that others may watch.
class Watched {
public:
  Watched() : executable(test::executableOf(kPatrol, false)) {}

  void start(const std::string& script = R"({"signals":[]})") {
    auto settings = defaultSettings(*executable);
    REQUIRE(
        readScript(runtime::JsonFile::parse(script).value(), executable->model, settings).empty());
    simulated = simulatedPlatform(std::move(settings), 1);
    platform = withInbox(*simulated, inbox, false);
    clock = pausableClock(runtime::simulatedClock(), pause);
    thread = std::thread([this] {
      result =
          execute(*executable, *clock, *platform, counter,
                  {.seed = 7, .until = 600 * kSecond, .stopRequests = &stops, .pause = &pause});
    });
  }

  /// Waits until this many steps have been taken.
  void await(std::size_t steps) {
    for (auto seen = counter.count.load(); seen < steps; seen = counter.count.load())
      counter.count.wait(seen);
  }

  const std::string& end() {
    thread.join();
    return counter.text;
  }

  struct Counter final : runtime::Observer {
    explicit Counter(const Watched& of) : run(of) {}
    void onStep(const runtime::Machine& machine, verify::TransitionId step, Nanoseconds date,
                Nanoseconds) override {
      for (const auto origin : lastStep(*run.executable, machine, step).origins)
        text += std::to_string(date) + " " +
                run.executable->model.provenance.origins[origin].description + "\n";
      ++count;
      count.notify_all();
    }
    void onRemark(const runtime::Remark& remark) override {
      if (remark.kind == runtime::RemarkKind::Note) text += std::string(remark.text) + "\n";
    }
    const Watched& run;
    std::string text;
    std::atomic<std::size_t> count = 0;
  };

  std::unique_ptr<const runtime::Executable> executable;
  runtime::Pause pause;
  runtime::SignalInbox inbox{pause.wakeUp};
  std::atomic<int> stops = 0;
  Counter counter{*this};
  runtime::RunResult result;

private:
  std::unique_ptr<runtime::Platform> simulated;
  std::unique_ptr<runtime::Platform> platform;
  std::unique_ptr<runtime::Clock> clock;
  std::thread thread;
};

std::string undisturbed() {
  Watched run;
  run.start();
  return run.end();
}

std::uint32_t signalOf(const Watched& run, const std::string& name) {
  const auto& all = run.executable->model.signals;
  return static_cast<std::uint32_t>(std::ranges::find(all, name, &codegen::Signal::name) -
                                    all.begin());
}

} // namespace

TEST_CASE("a queue of bytes passes all entries on in their order, and says when it is full") {
  runtime::ByteQueue<int> queue(8'000);
  std::thread reader([&] {
    runtime::Random random(2);
    for (int next = 0; next < 200'000;) {
      const auto use = [&](int head, std::string_view bytes) {
        if (head != next || bytes != std::string(head % 977, static_cast<char>('a' + head % 26)))
          FAIL("entry " << next);
        ++next;
      };
      // It is sometimes slow, so that the queue is full.
      if (random.below(1'000) == 0) std::this_thread::yield();
      if (!queue.pop(use)) std::this_thread::yield();
    }
  });
  std::size_t full = 0;
  for (int i = 0; i < 200'000; ++i)
    while (!queue.push(i, std::string(i % 977, static_cast<char>('a' + i % 26)))) {
      ++full;
      std::this_thread::yield();
    }
  reader.join();
  CHECK(full > 0);
  CHECK(queue.used() == 0);
}

TEST_CASE("a queue of bytes starts again where it is empty, and uses its memory to the last byte") {
  runtime::ByteQueue<int> queue(4u << 20);
  const std::string bytes(300'000, 'x');
  std::size_t passed = 0;
  const auto use = [&](int, std::string_view entry) { passed += entry == bytes ? 1 : 0; };
  for (int round = 0; round < 50; ++round) {
    std::size_t pushed = 0;
    while (queue.push(0, bytes)) ++pushed;
    CHECK(pushed >= 12);
    for (std::size_t i = 0; i < pushed; ++i) CHECK(queue.pop(use));
    CHECK_FALSE(queue.pop(use));
    passed -= pushed;
  }
  CHECK(passed == 0);
}

TEST_CASE("a bounded queue passes all elements on in their order, and says when it is full") {
  runtime::BoundedQueue<int> queue(3);
  const auto add = [&](int number) { return queue.push([&](int& to) { to = number; }); };
  CHECK((add(1) && add(2) && add(3)));
  CHECK_FALSE(add(4));
  CHECK(queue.size() == 3);
  int sum = 0;
  while (queue.pop([&](int it) { sum = 10 * sum + it; })) {
  }
  CHECK(sum == 123);
  constexpr int kCount = 100'000;
  std::thread sender([&] {
    for (int i = 0; i < kCount; ++i)
      while (!add(i)) std::this_thread::yield();
  });
  int expected = 0;
  bool isInOrder = true;
  while (expected < kCount)
    if (!queue.pop([&](int it) { isInOrder = isInOrder && it == expected++; }))
      std::this_thread::yield();
  sender.join();
  CHECK(isInOrder);
}

TEST_CASE(
    "a paused run takes the steps that it is allowed, with the dates of a run without pauses") {
  Watched run;
  run.pause.hold();
  run.start();
  for (std::size_t i = 1; i <= 4; ++i) {
    run.pause.step();
    run.await(i);
    CHECK(run.counter.count == i);
  }
  run.pause.resume();
  CHECK(run.end() == undisturbed());
  CHECK(run.result.end == End::Mission);
}

TEST_CASE("pauses at any time change no step and no date in simulated time") {
  const auto expected = undisturbed();
  for (int i = 0; i < 20; ++i) {
    Watched run;
    run.start();
    std::thread other([&] {
      for (int k = 0; k < 50; ++k) {
        run.pause.hold();
        run.pause.step();
        run.pause.resume();
      }
    });
    other.join();
    REQUIRE(run.end() == expected);
  }
}

TEST_CASE("an event that is sent while a run is paused comes when it goes on, before time passes") {
  Watched run;
  run.pause.hold();
  run.start();
  run.pause.step();
  run.await(1);
  CHECK(run.inbox.send(signalOf(run, "storm")));
  CHECK(run.inbox.waiting() == 1);
  run.pause.resume();
  CHECK(run.end().find("\n0 occurs\n") != std::string::npos);
  CHECK(run.inbox.waiting() == 0);
}

TEST_CASE("an interrupt that is sent ends the skill as one of the platform does") {
  Watched run;
  run.pause.hold();
  run.start(R"({"signals":[],"actions":{"fly":[{"result":"there","after":3}]}})");
  for (std::size_t i = 1; i <= 3; ++i) { // the mission starts, calls, and the skill starts
    run.pause.step();
    run.await(i);
  }
  CHECK(run.inbox.send(signalOf(run, "fly")));
  run.pause.resume();
  const auto& text = run.end();
  INFO(text);
  CHECK(text.find("0 is interrupted from outside") != std::string::npos);
  CHECK(text.find("3000000000 ") == std::string::npos); // the action has been stopped
}

TEST_CASE("what is sent to a skill that does not run is noted, and changes nothing") {
  Watched run;
  run.pause.hold();
  run.start();
  for (std::size_t i = 1; i <= 5; ++i) { // the mission waits between two flights
    run.pause.step();
    run.await(i);
  }
  CHECK(run.inbox.send(signalOf(run, "fly")));
  run.pause.resume();
  auto text = run.end();
  const std::string note = "there is nothing to interrupt\n";
  const auto at = text.find(note);
  REQUIRE(at != std::string::npos);
  CHECK(text.erase(at, note.size()) == undisturbed());
}

TEST_CASE("a paused run ends on request") {
  Watched run;
  run.pause.hold();
  run.start();
  run.pause.step();
  run.await(1);
  ++run.stops;
  run.pause.wakeUp.ring();
  run.end();
  CHECK(run.result.end == End::Stopped);
  CHECK_FALSE(run.pause.isHeld());
}

TEST_CASE("no more signals wait than the queue holds") {
  runtime::WakeUp wakeUp;
  runtime::SignalInbox inbox(wakeUp);
  int sent = 0;
  while (inbox.send(0)) ++sent;
  CHECK(sent == 64);
  std::uint32_t signal = 1;
  CHECK(inbox.take(signal));
  CHECK(signal == 0);
  CHECK(inbox.send(0));
}
