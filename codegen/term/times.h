#pragma once

#include "codegen/model.h"
#include "fiacre/syntax/tree.h"

#include <expected>

namespace proskill::codegen {

/// Seconds as natural units of the model. Offline the unit is the largest that makes every bound of
/// the program an integer, and at most a second; at runtime it is a tick, and each wait lasts a
/// certain number of them, since Hippo waits punctually.
class Times {
public:
  /// Reads every bound of the program. An error where one has no place among the naturals of 31
  /// bits that Fiacre's compilers take, or, at runtime, is no whole number of ticks.
  static std::expected<Times, GenerationError> of(const analysis::Program& program,
                                                  const Options& options);

  /// Seconds in one step of the model.
  [[nodiscard]] syntax::Rational unit() const { return {1, perSecond}; }
  [[nodiscard]] std::int64_t units(syntax::Rational seconds) const;
  [[nodiscard]] fiacre::Interval interval(const syntax::Interval& seconds) const;
  /// How long a body waits: at runtime the first tick of the interval.
  [[nodiscard]] fiacre::Interval waiting(const syntax::Interval& seconds) const;

private:
  std::int64_t perSecond = 1;
  bool punctual = false;
};

} // namespace proskill::codegen
