#pragma once

#include "tests/support/oracle/evaluation.h"

namespace proskill::oracle {

/// A path through the statement of a `from` with its store: one process' part in a step.
struct Path {
  Store store;
  std::size_t instance = 0;
  std::vector<const fiacre::Statement*> branches; ///< for each `select` that was passed
  /// For a `select` with `unless`: which one, and which of its parts.
  std::optional<std::pair<const fiacre::Statement*, std::size_t>> rank;
  std::vector<std::int64_t> choices; ///< for each `any`: a value is a transition, as in a net
  std::optional<fiacre::Interval> wait;
  std::optional<std::size_t> port;
  Store message;      ///< sent or received values, in order
  bool takes = false; ///< it was received
  std::vector<std::string> tags;
  std::vector<fiacre::OriginId> origins;
  std::optional<std::size_t> target; ///< the target state
  bool loops = false;
};

/// Enumerates the paths of a statement by depth-first search, each with a store of its own.
class PathWalk {
public:
  PathWalk(const Interpreter& of, std::size_t which) : model(of), instance(which) {}

  /// All paths from `store` whose guards are true.
  [[nodiscard]] std::vector<Path> from(const fiacre::Statement& statement, const Store& store);

private:
  /// The rest of a path; `value` is the next of a `foreach`.
  struct Task {
    const fiacre::Statement* statement;
    std::optional<std::int64_t> value;
  };
  using Tasks = std::vector<Task>; // the next one is last

  void walk(Path path, Tasks tasks);
  void step(const fiacre::Statement& statement, Path path, Tasks tasks);
  void branch(const fiacre::Statement& statement, const Path& path, const Tasks& tasks);
  void any(const fiacre::Statement& statement, const Path& path, const Tasks& tasks,
           std::size_t target);
  void repeat(const Task& task, Path path, Tasks tasks);
  void assign(const fiacre::Statement& statement, Path& path);
  void leave(const fiacre::Statement& statement, Path& path);
  void select(const fiacre::Statement& statement, const Path& path, const Tasks& tasks);
  void choosePort(const fiacre::Statement& statement, Path& path);
  [[nodiscard]] const std::vector<fiacre::Type>& valueTypes(const std::string& port) const;

  [[nodiscard]] Evaluation in(Path& path) const;

  const Interpreter& model;
  std::size_t instance;
  std::vector<Path> found;
};

} // namespace proskill::oracle
