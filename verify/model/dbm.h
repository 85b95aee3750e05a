#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

/// Difference bound matrices. Dill, "Timing assumptions and verification of finite-state concurrent
/// systems", 1989; Bengtsson and Yi, "Timed automata: semantics, algorithms and tools", 2004.
namespace proskill::verify {

/// An upper bound on a difference of clocks: `<= c` is 2c + 1, `< c` is 2c. Tighter bounds are
/// smaller numbers.
using Bound = std::int32_t;

inline constexpr Bound kInfinite = INT32_MAX;
inline constexpr Bound kZero = 1; ///< `<= 0`

[[nodiscard]] constexpr Bound bound(std::int64_t constant, bool strict) {
  return static_cast<Bound>(2 * constant + (strict ? 0 : 1));
}
[[nodiscard]] constexpr Bound plus(Bound a, Bound b) {
  if (a == kInfinite || b == kInfinite) return kInfinite;
  return a + b - ((a | b) & 1);
}
[[nodiscard]] constexpr std::int32_t constantOf(Bound b) { return b >> 1; }

/// Called between parts of a long operation; it may throw to end the operation, which leaves the
/// zone undefined.
using Between = std::function<void()>;

/// Operations on so many clocks or more take long: those of cubic time, a millisecond.
inline constexpr std::uint32_t kManyClocks = 100;

/// A zone: the set of values of clocks x1 … xn such that each xi - xj is within entry (i, j); x0 is
/// 0. Zones are canonical (closed): every bound is as tight as the others imply, so equal zones
/// have equal matrices.
class Dbm {
public:
  Dbm() = default;
  /// All clocks are 0.
  explicit Dbm(std::uint32_t clocks) : size(clocks + 1), entries(size * size, kZero) {}
  Dbm(std::uint32_t dimension, std::span<const Bound> from)
      : size(dimension), entries(from.begin(), from.end()) {}

  [[nodiscard]] std::uint32_t dimension() const { return size; } ///< number of clocks + 1
  [[nodiscard]] Bound at(std::uint32_t i, std::uint32_t j) const { return entries[i * size + j]; }
  [[nodiscard]] std::span<const Bound> matrix() const { return entries; }

  /// Adds the constraint xi - xj below `limit`. Returns false if the zone becomes empty; its
  /// content is then undefined.
  bool constrain(std::uint32_t i, std::uint32_t j, Bound limit);
  /// Lets time pass: removes the upper bounds of all clocks.
  void up();
  /// Projects the zone to other clocks: new clock k is old clock from[k], or 0 if from[k] is 0.
  /// `from` starts with the first clock, not with x0.
  [[nodiscard]] Dbm over(std::span<const std::uint32_t> from) const;
  /// Abstracts the zone: drops bounds that no guard can distinguish. This is the operator Extra+LU
  /// of Behrmann, Bouyer, Larsen and Pelanek, "Lower and upper bounds in zone-based abstractions of
  /// timed automata", STTT 2006. `lower[i]` and `upper[i]` are the greatest constants to which
  /// clock i is compared from below and from above, negative if there are none; index 0 is unused.
  /// \param between called where there are many clocks
  void extrapolate(std::span<const std::int32_t> lower, std::span<const std::int32_t> upper,
                   const Between& between = {});
  /// Restricts clock k to at most limits[k - 1], for all clocks. Returns false if the zone becomes
  /// empty; its content is then undefined.
  /// \param between called where there are many clocks
  bool constrainAll(std::span<const Bound> limits, const Between& between = {});
  /// Makes clock `i` the new 0 and keeps all entries: clock i becomes 0 minus the old 0.
  void startAt(std::uint32_t i);
  /// Makes any moment between the old 0 and the first of the clocks the new 0.
  void startBefore();
  /// Gives clock `i` new bounds, independent of the other clocks: `lower` limits 0 - xi, `upper`
  /// limits xi - 0.
  void replace(std::uint32_t i, Bound lower, Bound upper);
  /// Computes the canonical form (Floyd and Warshall). Returns false if the zone is empty.
  /// \param between called where there are many clocks
  bool close(const Between& between = {});

private:
  [[nodiscard]] Bound& entry(std::uint32_t i, std::uint32_t j) { return entries[i * size + j]; }

  std::uint32_t size = 1;
  std::vector<Bound> entries{kZero};
};

/// Whether zone `outer` includes zone `inner`: no entry of `inner` exceeds that of `outer`. \pre
/// both have the same dimension
[[nodiscard]] bool includes(std::span<const Bound> outer, std::span<const Bound> inner);

} // namespace proskill::verify
