#pragma once

#include "ide/snapshot/snapshot.h"

#include <optional>
#include <vector>

/// From a name to the other places of the same name. All of them give nothing where no name stands.
namespace proskill::ide {

/// The symbol that a place names; the place may be just behind the name.
[[nodiscard]] std::optional<analysis::Occurrence> occurrenceAt(const View& view, syntax::Offset at);

/// Where the name was defined.
[[nodiscard]] std::optional<analysis::Location> definition(const View& view, syntax::Offset at);

/// Of what has a type, the definition of the type: a value's or a parameter's state variable.
[[nodiscard]] std::optional<analysis::Location> typeDefinition(const View& view, syntax::Offset at);

/// What sets a state variable, or sets it to the value that is named.
[[nodiscard]] std::vector<analysis::Location> implementations(const View& view, syntax::Offset at);

/// Every place that names the symbol, in the order of the files; its definition where asked for.
[[nodiscard]] std::vector<analysis::Location> references(const View& view, syntax::Offset at,
                                                         bool withDefinition);

/// The same within the file, with what each place does.
[[nodiscard]] std::vector<analysis::Occurrence> highlights(const View& view, syntax::Offset at);

} // namespace proskill::ide
