#pragma once

#include "verify/state/run.h"

#include <string>
#include <string_view>

/// The names that frac gives to the parts of a model's net, as far as they are known (see
/// docs/tina.md). A single `_` separates parts of a name, so a `_` within a name of the model is
/// doubled.
namespace proskill::verify {

/// The name with each `_` doubled: `rung_1` becomes `rung__1`.
[[nodiscard]] std::string doubled(std::string_view name);

/// `Scan_1` of the first instance of the process Scan.
[[nodiscard]] std::string tinaInstance(const System& system, InstanceId instance);

/// The place for an instance being at a location: `Scan_1_srung__1`.
[[nodiscard]] std::string tinaPlace(const System& system, InstanceId instance,
                                    std::uint32_t location);

/// A variable or a part of one: `Scan_1_vIN__01`, `{play_1_va.at[0].at[1]}`. A variable of the main
/// component belongs to its first instance: `{main_1_vskill.at[0].status}`.
/// \param main the name of the main component
[[nodiscard]] std::string tinaVariable(const System& system, CellId cell, std::string_view main);

/// A transition that was fired. In a synchronisation the later member comes first:
/// `TON_1_t0_Scan_1_t3`.
[[nodiscard]] std::string tinaTransition(const System& system, TransitionId transition,
                                         const StepLog& log);

} // namespace proskill::verify
