#include "runtime/clock/clock.h"
#include "tests/runtime/run_of.h"

#include <catch2/catch.hpp>

#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

using namespace proskill;

namespace {

/// The dates that were read from the system's clock of days, which the test sets at each reading.
int readings = 0;
bool setsDate = false;

} // namespace

// Replaces the function of the C library: somebody sets the date, to and fro.
extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const auto done = static_cast<int>(::syscall(SYS_clock_gettime, clock, time));
  if (setsDate && clock == CLOCK_REALTIME) time->tv_sec += ++readings % 2 == 0 ? -86'400 : 86'400;
  return done;
}

TEST_CASE("a date that is set during a run changes no step") {
  const auto executable = test::executableOf(
      "(defskill m :success done :body ((^ 0.01) (^ 0.01) (success done)))", false);
  const auto platform = simulatedPlatform(defaultSettings(*executable), 1);
  setsDate = true;
  timespec first{};
  timespec second{};
  clock_gettime(CLOCK_REALTIME, &first);
  clock_gettime(CLOCK_REALTIME, &second);
  const auto ran = test::runInRealTime(*executable, *platform, {});
  setsDate = false;
  CHECK(first.tv_sec - second.tv_sec > 86'400); // it is set
  CHECK(ran.when("m", "succeeds with `done`") == 0.02);
  CHECK(ran.remarks.empty());
}
