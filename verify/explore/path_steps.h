#pragma once

#include "verify/explore/expander.h"

namespace proskill::verify {

/// A node on a path, as it is stored.
struct PathNode {
  std::vector<Word> state; ///< its stored words
  SignatureId signature = 0;
  ZoneId zone = 0;
  TransitionId step = kNone; ///< that leads to it from the node before, if that is known
};

/// The transitions along a path. Explorations store little of them, so this takes the steps again.
class PathSteps {
public:
  /// \pre the arguments outlive this
  /// \param with has the signatures and zones of the nodes
  PathSteps(const System& of, const Reductions& used, const Walker& by, Expander& with)
      : system(of), reductions(used), walker(by), expander(with) {}

  /// The steps from the initial state to the first node.
  [[nodiscard]] Steps toFirst() const;
  /// The steps from a node to one that was first reached from it.
  [[nodiscard]] Steps between(const PathNode& from, const PathNode& to);
  /// The steps at the last node that set open variables to values with which time may pass.
  [[nodiscard]] Steps atEnd(const std::vector<Word>& state) const;

private:
  [[nodiscard]] const Successor& find(const PathNode& from, const PathNode& to);
  [[nodiscard]] Walk walkFrom(const std::vector<Word>& state) const;
  void walkCalm(Walk& walk) const;

  const System& system;
  const Reductions& reductions;
  const Walker& walker;
  Expander& expander;
  Expansion again; ///< of a node, to find the step from it
};

} // namespace proskill::verify
