#pragma once

#include "verify/verify.h"

#include <chrono>

namespace proskill::verify {

/// A limit was met by work that has no result of its own to return. Whoever has one catches it:
/// what was decided before stays decided.
struct LimitMet {
  std::string which;
};

/// Watches over the limits of a verification, in all of its phases, and reports how it goes on.
class LimitWatch {
public:
  explicit LimitWatch(const Options& of);

  /// Which limit is met, empty where none is. Calls the progress function a few times a second.
  /// \param growth bytes that the tables of the caller may take at once before the next call
  [[nodiscard]] std::string met(const Progress& now, std::uint64_t growth = 0);
  /// To be called at least once per some 10 µs of work. Looks at the limits at every so many calls.
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
  double measured = -1; ///< when `bytes` was
  std::uint64_t bytes = 0;
  std::uint32_t calls = 0;
};

/// The memory of this process that is in use now, in bytes; 0 where the system does not say.
[[nodiscard]] std::uint64_t residentBytes();

} // namespace proskill::verify
