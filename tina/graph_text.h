#pragma once

#include "verify/graph/state_graph.h"

#include <iosfwd>
#include <string>
#include <string_view>

/// State graphs as text, for other tools.
namespace proskill::tina {

/// The format of CADP ("aut" manual page), which mCRL2 reads too: `des (0, transitions, states)`,
/// then a line for each transition.
void writeAut(std::ostream& out, const verify::StateGraph& graph);

/// The name that frac gives to the net of a model: `process_play_1`. For a component, by analogy.
[[nodiscard]] std::string netName(const fiacre::Program& program);

/// The text that ktzio prints for a `.ktz` file: each state with its marking and the targets of its
/// transitions.
/// \param name of the net
void writeKtzText(std::ostream& out, const verify::StateGraph& graph, std::string_view name);

} // namespace proskill::tina
