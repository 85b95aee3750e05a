#pragma once

#include "ide/snapshot/snapshot.h"

#include <string>
#include <vector>

/// The users of a symbol: the definitions that name it.
namespace proskill::ide {

/// Whether the place sets a state variable. For a value: whether this value is set.
[[nodiscard]] bool isSetting(const View& view, const analysis::Occurrence& place);

/// The top-level definitions that name the symbol in one of these roles, in the order of the
/// program, each once.
[[nodiscard]] std::vector<analysis::SymbolId> usersOf(const View& view, analysis::SymbolId symbol,
                                                      bool (*matters)(const View&,
                                                                      const analysis::Occurrence&));

/// "`a`", "`a`, `b` and `c`", "`a`, `b`, `c`, `d` and 7 more".
[[nodiscard]] std::string enumerate(const View& view,
                                    const std::vector<analysis::SymbolId>& symbols);

} // namespace proskill::ide
