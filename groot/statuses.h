#pragma once

#include "groot/processes.h"

#include <functional>

namespace proskill::groot {

/// The statuses of a tree's nodes along a run. They follow from where the processes of the run are
/// in their bodies, so that a state is all that has to be known of a step.
class Statuses {
public:
  /// A node has another status.
  using Changed = std::function<void(Uid uid, Status status)>;

  /// \pre the tree and the executable outlive this
  Statuses(const Tree& tree, const runtime::Executable& executable, Changed changed);

  /// The run has come to this state by a step. Allocates no memory and takes no lock.
  void follow(const verify::Word* state);
  /// The run has come to this state by steps that are not known: what had ended before is
  /// forgotten.
  void jump(const verify::Word* state);

  /// By uid, less 1: a status, or for an idle node 10 and the status that it had before.
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return now; }

private:
  /// The part of a tree whose process moves.
  struct Place {
    const Block& block;
    std::uint32_t instance;
    const Instance& in;
  };

  void move(const Process& process, const Process::Stand& from);
  void begin(const Process& process, NodeIndex node);
  void finish(const Process& process, NodeIndex from);
  void complete(const Process& process);
  void halt(const Process& process);
  void advance(const Process& process, NodeIndex from, NodeIndex to);
  /// A process goes on from a node. \param to nullopt: it ends
  void leave(const Place& at, NodeIndex from, std::optional<NodeIndex> to);
  void decide(const Place& at, NodeIndex test, std::optional<NodeIndex> to);
  /// The skill of a root has this status.
  void tellProgram(const Place& at, Status status);

  [[nodiscard]] Place placeOf(const Process& process) const;
  [[nodiscard]] std::uint32_t calledInstance(std::uint32_t block) const;
  [[nodiscard]] bool isCalled(const Instance& instance) const;
  [[nodiscard]] Status outcomeOf(std::string_view skill) const;
  void run(const Place& at, NodeIndex node);
  void end(const Place& at, NodeIndex node, Status status);
  void rest(const Place& at, NodeIndex first, NodeIndex last);
  void set(Uid uid, Status status);

  const Tree& tree;
  const verify::System& system;
  const Changed changed;
  const std::map<std::string, Outcome, std::less<>> outcomes; ///< by skill
  std::vector<Process> processes;
  std::vector<std::uint32_t> active; ///< by block: the instance that was called last
  std::vector<std::uint8_t> now;
  const verify::Word* state = nullptr; ///< while it is followed
};

} // namespace proskill::groot
