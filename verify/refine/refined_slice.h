#pragma once

#include "verify/refine/contraction.h"
#include "verify/refine/precision.h"
#include "verify/state/enabled.h"
#include "verify/trace/dates.h"

#include <optional>
#include <vector>

namespace proskill::verify {

/// A slice for some questions, contracted, and the dates of its runs.
class RefinedSlice {
public:
  /// \param goals ask for reachable states or steps \throw LimitMet
  RefinedSlice(const Precision& precision, const std::vector<Goal>& goals, LimitWatch& limits);
  RefinedSlice(const RefinedSlice&) = delete;
  RefinedSlice& operator=(const RefinedSlice&) = delete;

  /// The system to search, without a state layout.
  [[nodiscard]] const System& part() const { return contraction.system; }
  [[nodiscard]] const Slice& uncontracted() const { return slice; }
  /// Steps of part() as steps of the slice.
  [[nodiscard]] Steps inSlice(const Steps& steps) const;
  /// Dates for steps of the slice, if it can take them. \throw LimitMet
  [[nodiscard]] std::optional<Dating> datingOf(const Steps& steps);

private:
  Slice slice;
  Contracted contraction;
  LimitWatch& limits;
  std::optional<System> allCells; ///< the slice with every cell kept, once it has a run
  std::optional<Enabling> enabling;
};

} // namespace proskill::verify
