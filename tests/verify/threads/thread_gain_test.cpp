#include "verify/threads/thread_gain.h"

#include <catch2/catch.hpp>

namespace proskill::test::thread_gain_test {

namespace {

struct Speeds {
  double threads = 0; ///< steps per second
  double alone = 0;
};

/// Works for some time in pieces of a millisecond. \return the share of the steps of threads
double shareOfThreads(verify::ThreadGain& gain, const Speeds& speeds, double seconds) {
  constexpr double kPiece = 0.001;
  double byThreads = 0;
  double all = 0;
  for (double passed = 0; passed < seconds; passed += kPiece) {
    const bool isByThreads = gain.areThreadsFaster();
    const double steps = kPiece * (isByThreads ? speeds.threads : speeds.alone);
    all += steps;
    if (isByThreads) byThreads += steps;
    gain.add(kPiece, static_cast<std::uint64_t>(steps));
  }
  return byThreads / all;
}

} // namespace

TEST_CASE("threads work where they are faster than one, and one alone where it is") {
  verify::ThreadGain gain;
  CHECK(shareOfThreads(gain, {2e6, 1e6}, 20) > 0.95);
  CHECK(shareOfThreads(gain, {1e6, 2e6}, 20) < 0.1); // the processors are busy now
  CHECK(shareOfThreads(gain, {2e6, 1e6}, 20) > 0.9);
}

TEST_CASE("the first trial is soon") {
  verify::ThreadGain gain;
  CHECK(shareOfThreads(gain, {1e6, 2e6}, 1) < 0.1);
}

} // namespace proskill::test::thread_gain_test
