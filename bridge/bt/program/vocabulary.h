#pragma once

#include "bridge/bt/tree/traits.h"
#include "bridge/text/form.h"
#include "bridge/text/names.h"

namespace proskill::bridge::bt {

/// The name that its author gave to a node, or else its type.
[[nodiscard]] inline const std::string& wordOf(const Node& node) {
  return node.name.empty() ? node.id : node.name;
}

/// A child that can run of a reactive node that has several: it goes on only in a tick that reaches
/// it, and it is halted when one before it runs on.
struct Turn {
  std::string reached; ///< variable: the child that the tick has reached, from 2; 0 otherwise
  std::string kept;    ///< variable: the child that runs since an earlier tick; `none` if none does
  std::vector<std::string> runs; ///< a variable for each child: 1 while what takes time runs in it
  std::size_t child = 1;
  std::string halted; ///< label: where each part goes that is halted; empty: a race halts them all

  [[nodiscard]] std::string none() const { return std::to_string(runs.size() + 1); }
  [[nodiscard]] const std::string& runsHere() const { return runs[child - 1]; }
  [[nodiscard]] Form isReached() const;
  /// That something runs in a child before this one. If it ends at once, it was not so.
  [[nodiscard]] Form isHalted() const;
};

/// The definitions of a program, as they are needed: variables, events, skills.
class Vocabulary {
public:
  Vocabulary(const Leaves& leaves, const std::filesystem::path& folder)
      : leaves(leaves), folder(folder), traits(leaves) {}

  /// The variable that says what a condition would return. Equal types with equal ports share one.
  std::string condition(const Node& node);
  /// The same for a place that watches the condition: no two of them share a variable.
  std::string watched(const Node& node);
  /// A variable that may have any of the values at any time.
  std::string anyOf(const std::string& wish, const std::vector<std::string>& values,
                    const std::string& comment);
  /// A number from 0 to `most`, which is 0 at first unless another one is given.
  std::string counter(const Node& node, const std::string& suffix, std::int64_t most,
                      std::int64_t init = 0);
  /// The basic skill of an action.
  std::string action(const Node& node);
  /// Adds a composite skill, without its outcomes.
  /// \param guard ends the skill as soon as it is false; empty: none
  void composite(const std::string& name, const std::string& comment, Block body,
                 const std::optional<Form>& guard = {});
  void approximate(const Node& node, std::string message);
  void fail(const Node& node, std::string message);

  /// The line of a comment for a node: its place, its type, and its name.
  [[nodiscard]] std::string comment(const Node& node) const;
  /// All definitions: variables, then skills, then properties.
  [[nodiscard]] Block program() const;

  const Leaves& leaves;
  const std::filesystem::path folder;
  const Traits traits;
  NamePool names;
  std::vector<Note> notes;
  std::vector<Note> remarks; ///< about what may not be meant; verdicts stay exact
  Errors errors;
  std::vector<std::string> undeclared; ///< types of leaves that were taken as actions
  Block properties;
  std::optional<Turn> turn; ///< of the node that is being translated
  bool isRepeated = false;  ///< that node may start several times
  /// Variables that are 1 while an action or a wait of this node runs.
  std::vector<std::string> marks;

  std::map<std::string, Place> actions; ///< where each basic skill comes from
  /// The names of actions, by types of nodes.
  std::map<std::string, std::string> commands;

  /// All marks become 1 or 0. \pre there are some
  [[nodiscard]] Form marksBecome(const char* value) const;

private:
  std::string declareCondition(const Node& node);
  /// An outcome of an action, with the end of the marks.
  [[nodiscard]] Form outcome(const char* tag, bool isMarked) const;
  /// The `:action` of a node: a name for its type, and the values of its ports.
  Form command(const Node& node);

  std::map<std::string, std::string> conditions; ///< by type and ports
  NamePool commandNames;
  Block variables;
  Block skills;
};

} // namespace proskill::bridge::bt
