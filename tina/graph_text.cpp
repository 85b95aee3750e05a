#include "tina/graph_text.h"
#include "verify/graph/tina_names.h"

#include <algorithm>
#include <ostream>

namespace proskill::tina {

using verify::StateGraph;

namespace {

/// Writes `  S [n]: 2 properties: a b`; the plural is that of ktzio.
void writeSpace(std::ostream& out, std::string_view head, const std::vector<std::string>& names) {
  out << "  " << head << ": " << names.size()
      << (names.size() == 1 ? " property:" : " properties:");
  for (const auto& name : names) out << ' ' << name;
  out << '\n';
}

void writeMarking(std::ostream& out, const StateGraph& graph, const StateGraph::Marking& marking) {
  out << "props";
  for (const auto& [property, value] : marking) {
    out << ' ' << graph.properties[property];
    if (value != 1) out << '*' << value;
  }
  out << '\n';
}

} // namespace

std::string netName(const fiacre::Program& program) {
  const bool process = std::ranges::find(program.processes, program.main, &fiacre::Process::name) !=
                       program.processes.end();
  return (process ? "process_" : "component_") + verify::doubled(program.main) + "_1";
}

void writeAut(std::ostream& out, const StateGraph& graph) {
  out << "des (0, " << graph.edges.size() << ", " << graph.markingOf.size() << ")\n";
  for (const auto& edge : graph.edges)
    out << '(' << edge.source << ", \"" << graph.labels[edge.label] << "\", " << edge.target
        << ")\n";
}

void writeKtzText(std::ostream& out, const StateGraph& graph, std::string_view name) {
  out << "# Created by ProSkill\n\nkts " << name << '\n';
  out << graph.markingOf.size() << " nodes\n" << graph.edges.size() << " edges\n";
  out << "1 state property namespace(s)\n";
  writeSpace(out, "S [n]", graph.properties);
  out << "1 transition property namespace(s)\n";
  writeSpace(out, "E", graph.labels);
  out << graph.markings.size() << " state property sets\n";
  auto edge = graph.edges.begin();
  for (std::uint32_t state = 0; state < graph.markingOf.size(); ++state) {
    out << "\nstate " << state << '\n';
    writeMarking(out, graph, graph.markings[graph.markingOf[state]]);
    out << "trans";
    for (; edge != graph.edges.end() && edge->source == state; ++edge)
      out << ' ' << graph.labels[edge->label] << '/' << edge->target;
    out << '\n';
  }
}

} // namespace proskill::tina
