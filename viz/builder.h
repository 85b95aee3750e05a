#pragma once

#include "analysis/program/program.h"
#include "viz/graph.h"

#include <string>
#include <string_view>
#include <vector>

namespace proskill::viz {

/// An edge with a known source whose target is not known yet.
struct Exit {
  std::size_t from = 0;
  EdgeRole role = EdgeRole::Next;
  std::string label;
  std::optional<Source> source;
};
using Exits = std::vector<Exit>;

/// Builds a graph from definitions in one file of a program.
class Builder {
public:
  Builder(const analysis::Program& shown, syntax::FileId where) : program(shown), file(where) {}

  std::size_t node(NodeRole role, std::string label, syntax::Range range,
                   std::vector<std::string> details = {});
  void edge(Edge edge) { graph.edges.push_back(std::move(edge)); }
  /// Connects all exits to a node.
  void connect(const Exits& exits, std::size_t to);
  /// The same; returns the exit of that node.
  Exits then(const Exits& exits, std::size_t to);

  /// Nodes added until `leaveCluster` belong to the cluster.
  void enterCluster(std::string label, syntax::Range range, bool labelRight = false);
  void leaveCluster();

  [[nodiscard]] Source source(syntax::Range range) const;
  /// The program's text on one line.
  [[nodiscard]] std::string text(syntax::Range range) const;
  /// One per line: `motion := Free`.
  [[nodiscard]] std::vector<std::string> effects(const syntax::Effects& effects) const;
  /// Seconds as written, with their unit.
  [[nodiscard]] std::string seconds(const syntax::Interval& interval) const;

  Graph graph;

private:
  const analysis::Program& program;
  syntax::FileId file;
  std::optional<std::size_t> cluster;
};

/// The range from the first to the last of the parts; only the first part's range if they are not
/// in order.
template <class Parts> syntax::Range span(const Parts& parts) {
  return parts.empty() ? syntax::Range{}
                       : syntax::Range{parts.front().range.begin, parts.back().range.end};
}

using SkillDefinition = analysis::Definition<syntax::Skill>;

/// Draws a skill from the call to its first step: precondition, resources, start effects.
/// \return the exits
Exits drawBeginning(Builder& builder, const SkillDefinition& skill);
/// Draws the node of an outcome: its tag, its effects, and its postcondition.
std::size_t drawOutcome(Builder& builder, NodeRole role, const syntax::Outcome& outcome);

Graph drawStateVariable(const analysis::Program& program,
                        const analysis::Definition<syntax::StateVariable>& variable,
                        bool forbidden);
Graph drawEvent(const analysis::Program& program, const analysis::Definition<syntax::Event>& event);
/// Whether the event has `:every` or a `:guard`. Others have nothing to show but their effects.
bool hasTimesOfItsOwn(const analysis::Definition<syntax::Event>& event);
Graph drawBasicSkill(const analysis::Program& program, const SkillDefinition& skill);
Graph drawBody(const analysis::Program& program, const SkillDefinition& skill);
Graph drawEnvironment(const analysis::Program& program,
                      const analysis::Definition<syntax::Environment>& environment);
Graph drawCalls(const analysis::Program& program);

} // namespace proskill::viz
