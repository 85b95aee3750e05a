#pragma once

#include "verify/verify.h"

#include <chrono>

namespace proskill::verify {

/// Thrown when work that has no partial result meets a limit. Whoever has a result catches it:
/// decided questions stay decided.
struct LimitMet {
  std::string which;
};

/// Checks the limits of a verification in all its phases, and reports progress.
class LimitWatch {
public:
  explicit LimitWatch(const Options& of);

  /// Returns the limit that is met, or an empty string. Calls the progress function a few times a
  /// second.
  /// \param growth bytes that the caller's tables may allocate at once before the next call
  [[nodiscard]] std::string met(const Progress& now, std::uint64_t growth = 0);
  /// Call this about every 10 µs of work, or more often. Checks the limits every kBetweenLooks
  /// calls.
  /// \throw LimitMet
  void check() {
    if (++calls >= kBetweenLooks) look();
  }
  [[nodiscard]] double seconds() const { return now() - start; }

private:
  using Clock = std::chrono::steady_clock;

  static constexpr std::uint32_t kBetweenLooks = 64;

  void look();
  [[nodiscard]] double now() const;
  [[nodiscard]] std::string passed(std::uint64_t counted, std::uint64_t growth);
  [[nodiscard]] std::uint64_t resident(double moment);

  const Options& options;
  double start = 0;
  double reported = 0;
  double measured = -1; ///< when `bytes` was measured
  std::uint64_t bytes = 0;
  std::uint32_t calls = 0;
};

/// Resident memory of this process in bytes; 0 if the system does not report it.
[[nodiscard]] std::uint64_t residentBytes();

} // namespace proskill::verify
