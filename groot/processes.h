#pragma once

#include "groot/tree.h"

#include <optional>

namespace proskill::groot {

/// As BehaviorTree.CPP numbers them.
enum class Status : std::uint8_t { Idle, Running, Success, Failure, Skipped };

/// A process of a run that executes a body or a branch of one, and the nodes at which it can be.
struct Process {
  /// What a location of the process means.
  struct Stand {
    std::optional<NodeIndex> node; ///< nullopt: at no statement
    bool isStopped = false;        ///< the process ends when all that it has called has ended
    bool isDone = false;           ///< the process does not run
    bool hasCalled = false;        ///< at a call that has been made
  };
  verify::CellId location = 0;
  std::uint32_t block = 0;
  std::optional<NodeIndex> branch; ///< of a branch: its first node
  std::vector<Stand> stands;       ///< by location
  std::optional<std::size_t> at{}; ///< its location; nullopt: it is not known yet

  [[nodiscard]] Stand stand() const { return at ? stands[*at] : Stand{.isDone = true}; }
  [[nodiscard]] NodeIndex top() const { return branch.value_or(0); }
};

/// All of them, callers first.
[[nodiscard]] std::vector<Process> processesOf(const Tree& tree,
                                               const runtime::Executable& executable);

/// Where a run keeps how a skill has ended.
struct Outcome {
  verify::CellId cell = 0;
  std::vector<Status> statuses; ///< by its value, less the cell's least one
};

/// By skill.
[[nodiscard]] std::map<std::string, Outcome, std::less<>>
outcomesOf(const runtime::Executable& executable);

} // namespace proskill::groot
