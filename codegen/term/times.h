#pragma once

#include "codegen/model.h"
#include "fiacre/syntax/tree.h"

#include <expected>

namespace proskill::codegen {

/// Converts seconds to integer time units of the model. In models to verify, the unit is the
/// largest one of at most a second in which every bound of the program is an integer. At runtime
/// the unit is a tick, and each wait lasts a fixed number of ticks, since Hippo waits punctually.
class Times {
public:
  /// Reads every bound of the program. Fails if one exceeds the 31 bits of naturals that Fiacre's
  /// compilers accept or, at runtime, is not an integer number of ticks.
  static std::expected<Times, GenerationError> of(const analysis::Program& program,
                                                  const Options& options);

  /// Seconds in one time unit of the model.
  [[nodiscard]] syntax::Rational unit() const { return {1, perSecond}; }
  [[nodiscard]] std::int64_t units(syntax::Rational seconds) const;
  [[nodiscard]] fiacre::Interval interval(const syntax::Interval& seconds) const;
  /// The interval of a wait in a body; at runtime only its first tick.
  [[nodiscard]] fiacre::Interval waiting(const syntax::Interval& seconds) const;

private:
  std::int64_t perSecond = 1;
  bool punctual = false;
};

} // namespace proskill::codegen
