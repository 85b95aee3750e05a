#pragma once

#include "bridge/bt/guard.h"

namespace proskill::bridge::bt {

/// Where a body continues after a node: with the next statement, or with a jump.
struct Exit {
  Block jump; ///< empty: the next statement

  [[nodiscard]] bool next() const { return jump.empty(); }
  friend bool operator==(const Exit&, const Exit&) = default;
};

/// Where it continues if the node is skipped: a jump. Nothing where a node must not be skipped.
using Skip = std::optional<Exit>;

/// Writes the body of one composite skill, or of one of its parallel branches. Sequences,
/// fallbacks, loops and decorators become statements and jumps. What must be able to stop its
/// children while they run becomes a composite skill of its own.
class Body {
public:
  explicit Body(Vocabulary& vocabulary) : vocabulary(vocabulary), traits(vocabulary.traits) {}

  /// Statements for a node. After them the node has ended, and control is at `success` or
  /// `failure`. Both may be the next statement: then the result does not matter.
  /// \param skip where control is if the node is skipped; without it, a node that may be is an
  /// error
  void node(const Node& node, const Exit& success, const Exit& failure, const Skip& skip = {});

  /// The same without regard to the scripts that decide about the node itself.
  void plain(const Node& node, const Exit& success, const Exit& failure, const Skip& given);

  /// The same for one start of the node.
  void started(const Node& node, const Exit& success, const Exit& failure, const Skip& given);

  /// The same for a child of a parallel node: its exits may count the end instead of jumping.
  void result(const Node& child, Exit success, Exit failure);

  /// The wait for another tick; `atOnce`: it may also be this one.
  [[nodiscard]] Form nextTick(bool atOnce) const;

  /// A wait. Where a tick has to reach it, it goes on in such a tick only.
  [[nodiscard]] Block lasting(Form wait) const;
  /// The same for the call of a basic skill, which says itself that it has started.
  [[nodiscard]] Block lastingAction(const Node& node, const std::string& skill) const;

  Block statements;

private:
  /// What follows a statement that has ended: the next tick that reaches it.
  [[nodiscard]] Block nextTurn() const;
  void preconditions(const Node& node, const Exit& success, const Exit& failure, const Skip& skip);
  void whileTrue(const Node& node, const Exit& success, const Exit& failure, const Exit& skip);
  void scripted(const Node& node, const std::string& port, const Exit& exit);
  void condition(const Node& node, const Exit& success, const Exit& failure);
  void action(const Node& node, const Exit& success, const Exit& failure);
  void composite(const Node& node, const Exit& success, const Exit& failure, const Skip& skip);
  /// What follows the call of a skill.
  /// \param byGuard whether it succeeds where its guard ends it
  void called(const std::string& skill, Ends ends, const Exit& success, const Exit& failure,
              const Skip& skip, bool byGuard = false);
  /// A child of a sequence or a fallback; after it and where it is skipped, control is at `goOn`.
  void child(const Node& child, bool isSequence, const Exit& goOn, const Exit& early);
  void inOrder(const Node& node, bool isSequence, const Exit& success, const Exit& failure,
               const Skip& skip);
  /// The same where all children may be skipped: then the node is.
  void inOrderOrSkipped(const Node& node, bool isSequence, const Exit& success, const Exit& failure,
                        const Exit& skip);
  void withMemory(const Node& node, const Exit& success, const Exit& failure);
  void ifThenElse(const Node& node, const Exit& success, const Exit& failure, const Skip& skip);
  void runOnce(const Node& node, const Exit& success, const Exit& failure, const Skip& skip);
  void precondition(const Node& node, const Exit& success, const Exit& failure, const Skip& skip);
  void queue(const Node& node, const Exit& success, const Exit& failure, const Skip& skip);
  void tryCatch(const Node& node, const Exit& success, const Exit& failure, const Skip& skip);
  void loop(const Node& node, const Exit& success, const Exit& failure);
  void endlessLoop(const Node& node, const Exit& exit);
  std::string waitBefore(const std::string& label, Form wait);
  void countedLoop(const Node& node, std::int64_t rounds, const Exit& success, const Exit& failure);
  void anyLoop(const Node& node, const Exit& success, const Exit& failure);
  void delay(const Node& node, const char* port);
  void recovery(const Node& node, const Exit& success, const Exit& failure);
  void anyOrder(const Node& node, bool isSequence, const Exit& success, const Exit& failure);
  void rate(const Node& node, const Exit& success, const Exit& failure, const Skip& skip);
  void parallelAll(const Node& node, const Exit& success, const Exit& failure);

  /// An exit that is a jump in any case: to `label`, where the next statement is meant.
  static Exit orTo(const Exit& exit, const std::string& label);
  static Exit to(const std::string& label);
  void test(const Form& condition, const Exit& exit);
  void leave(const Exit& exit) { append(statements, exit.jump); }
  void place(const std::string& label) { statements.push_back(list("label", label)); }
  [[nodiscard]] bool jumpsTo(const std::string& label) const;
  /// The same if a jump leads there.
  void placeUsed(const std::string& label);
  void commentAt(std::size_t statement, const Node& node);

  Vocabulary& vocabulary;
  const Traits& traits;
};

/// `(success done)` and `(failure failed)`.
[[nodiscard]] Exit succeed();
[[nodiscard]] Exit fail();
/// `(failure skipped)`, the third outcome of a composite skill.
[[nodiscard]] Exit skipped();
/// Whether a node may start a child again, before it is started again itself.
[[nodiscard]] bool repeatsChildren(const Node& node);
/// Milliseconds in a port as seconds. Nothing if it is not a number.
[[nodiscard]] std::optional<std::string> secondsIn(const std::string& port);

} // namespace proskill::bridge::bt
