#pragma once

#include <cstdint>

namespace proskill::verify {

/// Measures whether several threads are faster than one, and uses the faster way. Where other
/// programs keep the processors busy, threads that wait for each other are slower than one alone.
/// The slower way is tried again from time to time, since that changes.
class ThreadGain {
public:
  /// Whether the next piece of work is one for several threads.
  [[nodiscard]] bool areThreadsFaster() const { return isTrial != prefersThreads; }
  /// Call this after each piece of work. \param steps its size, in any unit
  void add(double seconds, std::uint64_t steps);

private:
  static constexpr double kBetweenTrials = 1; ///< seconds
  static constexpr double kTrial = 0.05;      ///< seconds

  bool prefersThreads = true;
  bool isTrial = false; ///< of the way that is not preferred
  double seconds = 0;   ///< since the last change of the way
  std::uint64_t steps = 0;
  double preferred = 0; ///< steps per second
};

} // namespace proskill::verify
