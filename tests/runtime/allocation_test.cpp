#include "runtime/control/signal_inbox.h"
#include "runtime/platform/simulated.h"
#include "tests/runtime/run_of.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <new>

using namespace proskill;

namespace {

bool countsAllocations = false;
std::size_t allocations = 0;

void* allocated(std::size_t size) {
  if (countsAllocations) ++allocations;
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

namespace {

/// Counts allocations between two steps.
class Counter final : public runtime::Observer {
public:
  static constexpr std::uint64_t kFirst = 2'000;
  static constexpr std::uint64_t kLast = 50'000;

  void onStep(const runtime::Machine&, verify::TransitionId, runtime::Nanoseconds,
              runtime::Nanoseconds) override {
    ++steps;
    countsAllocations = steps >= kFirst && steps < kLast;
  }
  void onRemark(const runtime::Remark& remark) override {
    ++remarks[static_cast<std::size_t>(remark.kind)];
  }

  std::uint64_t steps = 0;
  std::array<std::uint64_t, 8> remarks{};
};

} // namespace

TEST_CASE("no step of a run allocates memory after the start") {
  countsAllocations = true;
  ::operator delete(::operator new(1));
  countsAllocations = false;
  REQUIRE(allocations == 1); // it does count
  allocations = 0;
  const auto executable = test::executableOf(R"(
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
        (case (load what "b") ((success loaded) (^ 1)) (else (^ 2)))))))",
                                             false);
  // with everything that `--view` adds to the run itself
  runtime::Pause pause;
  runtime::SignalInbox inbox(pause.wakeUp);
  const auto clock = pausableClock(runtime::simulatedClock(), pause);
  const auto simulated = simulatedPlatform(defaultSettings(*executable), 1);
  const auto platform = withInbox(*simulated, inbox, false);
  Counter counter;
  runtime::RunOptions options{.until = 1'000'000 * runtime::kSecond, .pause = &pause};
  const auto result = execute(*executable, *clock, *platform, counter, options);
  countsAllocations = false;
  CHECK(result.end == runtime::End::Until);
  CHECK(counter.steps > Counter::kLast);
  using runtime::RemarkKind;
  for (const auto kind : {RemarkKind::Started, RemarkKind::Asked, RemarkKind::GuardFailed})
    CHECK(counter.remarks[static_cast<std::size_t>(kind)] > 100);
  CHECK(allocations == 0);
}
