#pragma once

#include "analysis/program/program.h"
#include "viz/graph.h"

#include <string>
#include <string_view>
#include <vector>

namespace proskill::viz {

/// An edge that knows where it comes from and not yet where it goes.
struct Exit {
  std::size_t from = 0;
  EdgeRole role = EdgeRole::Next;
  std::string label;
  std::optional<Source> source;
};
using Exits = std::vector<Exit>;

/// Makes a graph of what stands in one file of a program.
class Builder {
public:
  Builder(const analysis::Program& shown, syntax::FileId where) : program(shown), file(where) {}

  std::size_t node(NodeRole role, std::string label, syntax::Range range,
                   std::vector<std::string> details = {});
  void edge(Edge edge) { graph.edges.push_back(std::move(edge)); }
  /// Every way goes on to a node.
  void connect(const Exits& exits, std::size_t to);
  /// The same, and the way on from there.
  Exits then(const Exits& exits, std::size_t to);

  /// Nodes that are made until `leaveCluster` are in the cluster.
  void enterCluster(std::string label, syntax::Range range, bool labelRight = false);
  void leaveCluster();

  [[nodiscard]] Source source(syntax::Range range) const;
  /// The program's own words, on one line.
  [[nodiscard]] std::string text(syntax::Range range) const;
  /// `motion := Free`, one a line.
  [[nodiscard]] std::vector<std::string> effects(const syntax::Effects& effects) const;
  /// Seconds as they were written, with their unit.
  [[nodiscard]] std::string seconds(const syntax::Interval& interval) const;

  Graph graph;

private:
  const analysis::Program& program;
  syntax::FileId file;
  std::optional<std::size_t> cluster;
};

/// The range that spans all of these; that of the first where they are not in one row.
template <class Parts> syntax::Range span(const Parts& parts) {
  return parts.empty() ? syntax::Range{}
                       : syntax::Range{parts.front().range.begin, parts.back().range.end};
}

using SkillDefinition = analysis::Definition<syntax::Skill>;

/// From the call to the first step: precondition, resources, start effects.
/// \return the ways on
Exits drawBeginning(Builder& builder, const SkillDefinition& skill);
/// The outcome's node: its tag, its effects, what is checked then.
std::size_t drawOutcome(Builder& builder, NodeRole role, const syntax::Outcome& outcome);

Graph drawStateVariable(const analysis::Program& program,
                        const analysis::Definition<syntax::StateVariable>& variable,
                        bool forbidden);
Graph drawBasicSkill(const analysis::Program& program, const SkillDefinition& skill);
Graph drawBody(const analysis::Program& program, const SkillDefinition& skill);
Graph drawEnvironment(const analysis::Program& program,
                      const analysis::Definition<syntax::Environment>& environment);
Graph drawCalls(const analysis::Program& program);

} // namespace proskill::viz
