#pragma once

#include "verify/verify.h"

#include <array>
#include <string_view>

namespace proskill::verify {

/// A reduction of the state space as users name it. The one list of them: `--reduce`, its help, the
/// manual page and the completions are made from it.
struct ReductionName {
  Reduction reduction;
  std::string_view name;
  std::string_view formerName; ///< still taken, with a hint; empty where it never had another one
};

inline constexpr std::array kReductionNames{
    ReductionName{Reduction::DeadVariables, "dead-variables", ""},
    ReductionName{Reduction::LiveVariables, "live-variables", ""},
    ReductionName{Reduction::FreeInputs, "free-inputs", "open-variables"},
    ReductionName{Reduction::PrivateMoves, "private-moves", ""},
    ReductionName{Reduction::StubbornSets, "stubborn-sets", "safe-steps"},
    ReductionName{Reduction::Inclusion, "inclusion", ""},
    ReductionName{Reduction::Extrapolation, "extrapolation", ""},
};

} // namespace proskill::verify
