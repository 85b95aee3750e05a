#pragma once

#include <cstdint>
#include <span>
#include <vector>

/// Difference bound matrices. Dill, "Timing assumptions and verification of finite-state concurrent
/// systems", 1989; Bengtsson and Yi, "Timed automata: semantics, algorithms and tools", 2004.
namespace proskill::verify {

/// A bound `<= c` as 2c + 1, `< c` as 2c; the order of the numbers is that of the bounds.
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

/// A zone: the values of clocks x1 … xn with xi - xj bounded by entry (i, j), where x0 is 0. Always
/// closed, that is, every bound is as tight as the others make it, so that equal zones have equal
/// matrices.
class Dbm {
public:
  Dbm() = default;
  /// All clocks are 0.
  explicit Dbm(std::uint32_t clocks) : size(clocks + 1), entries(size * size, kZero) {}
  Dbm(std::uint32_t dimension, std::span<const Bound> from)
      : size(dimension), entries(from.begin(), from.end()) {}

  [[nodiscard]] std::uint32_t dimension() const { return size; } ///< clocks and the 0
  [[nodiscard]] Bound at(std::uint32_t i, std::uint32_t j) const { return entries[i * size + j]; }
  [[nodiscard]] std::span<const Bound> matrix() const { return entries; }

  /// Adds xi - xj below `limit`. False where nothing is left; the zone is then spoilt.
  bool constrain(std::uint32_t i, std::uint32_t j, Bound limit);
  /// Lets any time pass.
  void up();
  /// The zone over other clocks: new clock k is old clock from[k], or 0 where from[k] is 0. `from`
  /// starts with the first clock, not with the constant 0.
  [[nodiscard]] Dbm over(std::span<const std::uint32_t> from) const;
  /// Forgets bounds that no guard can see: the operator Extra+LU of Behrmann, Bouyer, Larsen and
  /// Pelanek, "Lower and upper bounds in zone-based abstractions of timed automata", STTT 2006.
  /// `lower[i]`, `upper[i]`: the greatest constants to which clock i is compared from below and
  /// from above, negative where there is none; index 0 unused.
  void extrapolate(std::span<const std::int32_t> lower, std::span<const std::int32_t> upper);
  /// Takes clock `i` as the new 0, and drops nothing: clock i becomes 0 - what was 0.
  void startAt(std::uint32_t i);
  /// Takes as the new 0 any moment from the old 0 to the first of the clocks.
  void startBefore();
  /// Gives clock `i` new bounds, unrelated to the other clocks: `lower` limits 0 - xi, `upper` xi -
  /// 0.
  void replace(std::uint32_t i, Bound lower, Bound upper);
  /// Floyd and Warshall. False where nothing is left.
  bool close();

private:
  [[nodiscard]] Bound& entry(std::uint32_t i, std::uint32_t j) { return entries[i * size + j]; }

  std::uint32_t size = 1;
  std::vector<Bound> entries{kZero};
};

/// Whether every entry of `inner` is at most that of `outer`. \pre same dimension
[[nodiscard]] bool includes(std::span<const Bound> outer, std::span<const Bound> inner);

} // namespace proskill::verify
