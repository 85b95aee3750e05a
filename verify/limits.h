#pragma once

#include "verify/verify.h"

#include <chrono>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace proskill::verify {

/// Thrown when work that has no partial result meets a limit. Whoever has a result catches it:
/// decided questions stay decided.
struct LimitMet {
  std::string which;
};

/// The limit that a search on disk may get around.
inline constexpr std::string_view kMemoryLimitMet = "the memory limit was reached";

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
  /// Call this before each step that adds to a vector that may be large.
  /// \throw LimitMet if the vector would exceed the memory limit when it grows
  template <class T> void checkGrowth(const std::vector<T>& all, std::size_t more) {
    if (all.capacity() - all.size() >= more || all.capacity() * sizeof(T) < kLarge) return;
    if (auto limit = passed(0, 2 * all.capacity() * sizeof(T)); !limit.empty())
      throw LimitMet{std::move(limit)};
  }
  /// Call this before tables may grow by so many bytes. Classes are not counted.
  /// \throw LimitMet
  void checkGrowth(std::uint64_t growth) {
    if (auto limit = passed(0, growth); !limit.empty()) throw LimitMet{std::move(limit)};
  }
  /// The same, unless these are few.
  /// \throw LimitMet
  void checkLargeGrowth(std::uint64_t growth) {
    if (growth >= kLarge) checkGrowth(growth);
  }
  /// Checks the limits at once. \throw LimitMet
  void checkNow() { checkGrowth(std::uint64_t{0}); }
  /// The same as a function. This object must live as long.
  [[nodiscard]] std::function<void()> asCheck() {
    return [this] { checkNow(); };
  }
  /// The number of threads to use by a search that has found so many classes, of which so many
  /// wait to be expanded.
  [[nodiscard]] unsigned jobsFor(std::uint64_t classes, std::uint64_t waiting) const {
    const bool isShort = classes < options.classesBeforeThreads ||
                         waiting < std::uint64_t{options.nodesBeforeThreads} * options.jobs;
    return isShort ? 1 : options.jobs;
  }
  /// Bytes that a search on disk may have for its tables if another search has met this limit;
  /// nothing if it is not that of memory. Call this when that search is gone.
  [[nodiscard]] std::optional<std::uint64_t> bytesForDiskSearch(std::string_view met);
  /// Seconds since the start, and those that earlier processes took for the same verification.
  [[nodiscard]] double seconds() const { return now() - start + earlier; }
  void addEarlier(double seconds) { earlier = seconds; }
  /// The limit that was met since forgetMet(); empty if there is none.
  [[nodiscard]] const std::string& lastMet() const { return last; }
  void forgetMet() { last.clear(); }

private:
  using Clock = std::chrono::steady_clock;

  static constexpr std::uint32_t kBetweenLooks = 64;
  static constexpr std::size_t kLarge = 1 << 20; ///< bytes

  void look();
  [[nodiscard]] double now() const;
  [[nodiscard]] std::string noted(std::string limit);
  [[nodiscard]] std::string passed(std::uint64_t counted, std::uint64_t growth);
  [[nodiscard]] std::uint64_t resident(double moment);

  const Options& options;
  double start = 0;
  double earlier = 0; ///< seconds
  double reported = 0;
  double measured = -1; ///< when `bytes` was measured
  std::uint64_t bytes = 0;
  std::uint32_t calls = 0;
  std::string last; ///< the limit that was met
};

/// Resident memory of this process in bytes; 0 if the system does not report it.
[[nodiscard]] std::uint64_t residentBytes();

} // namespace proskill::verify
