#pragma once

#include "ide/snapshot/snapshot.h"

#include <optional>
#include <vector>

/// Navigation from a name to other places of the same name. The functions return nothing if there
/// is no name at the place.
namespace proskill::ide {

/// The symbol named at a place; the place may be just after the name.
[[nodiscard]] std::optional<analysis::Occurrence> occurrenceAt(const View& view, syntax::Offset at);

/// The definition of the name.
[[nodiscard]] std::optional<analysis::Location> definition(const View& view, syntax::Offset at);

/// The definition of the symbol's type: the state variable of a value or a parameter.
[[nodiscard]] std::optional<analysis::Location> typeDefinition(const View& view, syntax::Offset at);

/// The places that set a state variable, or that set it to the named value.
[[nodiscard]] std::vector<analysis::Location> implementations(const View& view, syntax::Offset at);

/// All places that name the symbol, in the order of the files; its definition only on request.
[[nodiscard]] std::vector<analysis::Location> references(const View& view, syntax::Offset at,
                                                         bool withDefinition);

/// The same within the file, with the role of each place.
[[nodiscard]] std::vector<analysis::Occurrence> highlights(const View& view, syntax::Offset at);

} // namespace proskill::ide
