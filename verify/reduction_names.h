#pragma once

#include "verify/verify.h"

#include <array>
#include <string_view>

namespace proskill::verify {

/// The name of a reduction for users. `--reduce`, its help, the manual page and the completions are
/// generated from this list.
struct ReductionName {
  Reduction reduction;
  std::string_view name;
  std::string_view formerName; ///< still accepted, with a hint; empty if the name never changed
};

inline constexpr std::array kReductionNames{
    ReductionName{Reduction::DeadVariables, "dead-variables", ""},
    ReductionName{Reduction::LiveVariables, "live-variables", ""},
    ReductionName{Reduction::FreeInputs, "free-inputs", "open-variables"},
    ReductionName{Reduction::PrivateMoves, "private-moves", ""},
    ReductionName{Reduction::StubbornSets, "stubborn-sets", "safe-steps"},
    ReductionName{Reduction::Slices, "slices", ""},
    ReductionName{Reduction::Refinement, "refinement", ""},
    ReductionName{Reduction::Inclusion, "inclusion", ""},
    ReductionName{Reduction::Extrapolation, "extrapolation", ""},
};

} // namespace proskill::verify
