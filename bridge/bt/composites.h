#pragma once

#include "bridge/bt/body.h"

namespace proskill::bridge::bt {

/// Whether a reactive node has children after the conditions that it tests at each tick.
[[nodiscard]] bool needsWatching(const Node& reactive, const Traits& traits);

/// Whether a node is reactive, and only one of its children can run.
[[nodiscard]] bool isWatching(const Node& node, const Traits& traits);

/// Whether the parts of a node that takes time wait for their turn themselves, so that the node
/// need not.
[[nodiscard]] bool passesTurn(Kind kind);

/// Composite skills for the nodes that stop their children while these run.
class Composites {
public:
  explicit Composites(Vocabulary& vocabulary) : vocabulary(vocabulary), traits(vocabulary.traits) {}

  /// Adds the skill of a node. \return its name
  std::string of(const Node& node);
  /// The same for a node that is halted, and skipped, as soon as a condition holds.
  std::string whileTrue(const Node& node, const Form& until);

private:
  Block bodyOf(const Node& node);
  Block subTree(const Node& node);
  Block timeout(const Node& node);
  Block parallel(const Node& node);
  Block pipeline(const Node& node);
  Block nonblocking(const Node& node);
  Block pauseResume(const Node& node);
  Block own(const Node& node);
  Block tickedAndHalted(const Node& child, const std::string& wish);
  [[nodiscard]] std::vector<std::span<const Node>> pipelineParts(const Node& node) const;
  Block pipelineBranch(std::span<const Node> part, std::size_t place, const std::string& passed);
  Block branches(const Node& node, const Exit& success, const Exit& failure);
  Block whileDoElse(const Node& node);
  Block choice(const Node& node);
  Block reactive(const Node& node);
  /// The rest of a reactive node after the conditions that it begins with: a wait for the end of
  /// the child that can run.
  Block onlyOne(const Node& rest, const Exit& early, const Exit& late);
  /// The same where several children can run: a branch for each.
  Block inTurn(const Node& rest, const Exit& early, const Exit& late);
  Block branchInTurn(const Node& part, Turn turn, const Exit& early, const Exit& late);
  Block inTurnOnce(const Node& part, const Turn& turn, const Exit& early, const Block& after);
  Block betweenTicks(const Turn& turn);
  Turn turnOf(const Node& node, std::size_t children);
  static Block forget(const Turn& turn);
  void startsAgain(const Node& child);
  static Block passOn(const Turn& turn);
  Block watched(const Node& node, const Exit& success, const Exit& failure, const Form& until,
                const Skip& skip = {});

  Vocabulary& vocabulary;
  const Traits& traits;
  std::optional<Form> guard; ///< of the skill: the conditions that a reactive node begins with
};

/// The children of a parallel node by branch. A condition is tested in the branch of the next child
/// that can run, before it: so ticks read it before that child starts.
[[nodiscard]] std::vector<std::vector<const Node*>> branchesOf(const Node& node,
                                                               const Traits& traits);

} // namespace proskill::bridge::bt
