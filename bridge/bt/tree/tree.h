#pragma once

#include "bridge/text/place.h"

#include <expected>
#include <map>
#include <optional>
#include <set>
#include <string_view>

namespace proskill::bridge::bt {

enum class Kind : std::uint8_t {
  Action,
  Condition,
  Script, // changes the blackboard and succeeds
  Sleep,
  AlwaysSuccess,
  AlwaysFailure,
  Sequence,
  SequenceWithMemory,
  ReactiveSequence,
  Fallback,
  ReactiveFallback,
  Parallel,
  ParallelAll,
  IfThenElse,
  WhileDoElse,
  Switch,
  Inverter,
  ForceSuccess,
  ForceFailure,
  Repeat,
  Retry,
  KeepRunning,
  Timeout,
  Delay,
  RunOnce,
  Precondition, // a decorator that asks before it starts its child
  Queue,        // a loop over the elements of a queue
  TryCatch,
  Recovery, // of Nav2, as the next six
  RoundRobin,
  Persistent,
  Pipeline,
  Nonblocking,
  PauseResume,
  Rate, // a decorator that ticks its child less often
  Own,  // a control node or a decorator of the tree's author
  SubTree,
};

/// How many children a built-in node has.
struct BuiltIn {
  std::string_view name;
  Kind kind;
  std::size_t least;
  std::size_t most;
};

inline constexpr std::size_t kAnyNumber = SIZE_MAX;

/// The built-in node of this name, or null.
[[nodiscard]] const BuiltIn* builtIn(std::string_view name);

struct Node {
  Kind kind = Kind::Action;
  std::string id;   ///< the registered type, or the tree that a SubTree uses
  std::string name; ///< given by the author; empty if none
  Place place;
  std::map<std::string, std::string> ports; ///< without `ID` and `name`
  std::vector<Node> children;

  /// The value of a port, or the default.
  [[nodiscard]] std::string port(const std::string& called, std::string otherwise = {}) const;
};

/// What BehaviorTree.CPP reads as a true value.
[[nodiscard]] bool isTrue(std::string_view value);
/// Whether the value of a port is an entry of the blackboard: `{entry}`, or `${entry}` in
/// version 3.
[[nodiscard]] bool isEntry(std::string_view value);

struct Tree {
  std::string id;
  Place place;
  Node root;
};

/// A port that `TreeNodesModel` declares.
struct PortModel {
  bool isInput = true;
  bool isOutput = false;
  std::string byDefault; ///< its value where a node gives it none; empty: none
};

/// What the files declare.
struct Forest {
  std::map<std::string, Tree> trees;
  std::string main;
  Place place;                          ///< of the first file's root element
  std::map<std::string, Kind> declared; ///< by TreeNodesModel: actions, conditions, subtrees
  /// By TreeNodesModel: the ports of types that have some.
  std::map<std::string, std::map<std::string, PortModel, std::less<>>> ports;
  std::vector<Note> notes;             ///< about what may be an error
  std::set<std::string> ignored;       ///< attributes without effect, each in one note
  bool hasFormat = true;               ///< each file says that it is of version 4
  std::vector<std::string> undeclared; ///< types of leaves that were taken as actions
  std::vector<std::string> own;        ///< types of control nodes and decorators of its author
};

} // namespace proskill::bridge::bt
