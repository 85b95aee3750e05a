#pragma once

#include "ide/snapshot/snapshot.h"

#include <string>
#include <vector>

/// Who uses a symbol, by the definitions in which it is named.
namespace proskill::ide {

/// The place sets a state variable; of a value, it is the value that is set.
[[nodiscard]] bool isSetting(const View& view, const analysis::Occurrence& place);

/// The definitions at the top level in which the symbol is named in such a role, in the order of
/// the program, each once.
[[nodiscard]] std::vector<analysis::SymbolId> usersOf(const View& view, analysis::SymbolId symbol,
                                                      bool (*matters)(const View&,
                                                                      const analysis::Occurrence&));

/// "`a`", "`a`, `b` and `c`", "`a`, `b`, `c`, `d` and 7 more".
[[nodiscard]] std::string enumerate(const View& view,
                                    const std::vector<analysis::SymbolId>& symbols);

} // namespace proskill::ide
