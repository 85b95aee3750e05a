#pragma once

#include "verify/state/run.h"

#include <string>
#include <string_view>

/// The names that frac gives to the parts of the net that it makes of a model, as far as they are
/// known: docs/tina.md says which are. A single `_` separates parts, so that those within the
/// names of the model are doubled.
namespace proskill::verify {

/// `rung_1` as `rung__1`.
[[nodiscard]] std::string doubled(std::string_view name);

/// `Scan_1` of the first instance of the process Scan.
[[nodiscard]] std::string tinaInstance(const System& system, InstanceId instance);

/// The place that says that an instance is at a location: `Scan_1_srung__1`.
[[nodiscard]] std::string tinaPlace(const System& system, InstanceId instance,
                                    std::uint32_t location);

/// A variable or a part of one: `Scan_1_vIN__01`, `{play_1_va.at[0].at[1]}`. One of the main
/// component counts as of its first instance: `{main_1_vskill.at[0].status}`.
/// \param main the name of the main component
[[nodiscard]] std::string tinaVariable(const System& system, CellId cell, std::string_view main);

/// A transition as it was fired; of a synchronisation the later member comes first:
/// `TON_1_t0_Scan_1_t3`.
[[nodiscard]] std::string tinaTransition(const System& system, TransitionId transition,
                                         const StepLog& log);

} // namespace proskill::verify
