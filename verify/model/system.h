#pragma once

#include "fiacre/syntax/tree.h"
#include "verify/model/bits.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The transition system that `verify/` explores. compile() makes it from the Fiacre tree: a
/// variable becomes a bit field of a packed state, a path through a `from` a linear list of
/// instructions.
namespace proskill::verify {

using Word = std::uint64_t;
using CellId = std::uint32_t;
using NodeId = std::uint32_t;
using PathId = std::uint32_t;
using TransitionId = std::uint32_t;
using InstanceId = std::uint32_t;
using ClockId = std::uint32_t;
using EventId = std::uint32_t;
using FaultId = std::uint32_t; ///< index into System::faults

inline constexpr std::uint32_t kNone = UINT32_MAX;

/// Faults of every system.
inline constexpr FaultId kNoFault = 0;
inline constexpr FaultId kDivisionByZero = 1;
inline constexpr FaultId kOverflow = 2;

/// A scalar variable, or the location of an instance.
struct Cell {
  std::string name;
  std::int64_t low = 0;
  std::int64_t high = 0;
  std::int64_t initial = 0;
  std::uint32_t word = 0; ///< index in a packed state
  std::uint32_t shift = 0;
  Word mask = 0; ///< of its bits, in their position in the word
};

enum class NodeOp : std::uint8_t {
  Number, // the constant `number`
  Cell,   // the value of cell a
  // (word a & mask) == value; replaces comparisons with constants once states have a layout
  Test,
  Not,
  Negate, // a
  And,
  Or,
  Equal,
  Less,
  LessEqual, // a, b
  Add,
  Subtract,
  Multiply,
  Divide,
  Modulo,      // a, b
  Conditional, // a ? b : c
  Happens,     // whether event a happens in the observed step
  Entered,
  Left, // whether the step makes a true, from false
  // The a-th value sent on the port; replaced when the parts of a synchronisation are combined.
  Received,
  Require, // b if a holds, otherwise fault c. If `number` is set, `low` and `high` bound b then
  Fails,   // whether evaluating a causes a fault
};

/// An expression over cells. Equal expressions share one node.
struct Node {
  NodeOp op = NodeOp::Number;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t c = 0;
  std::int64_t number = 0;
  Word mask = 0;
  Word value = 0;
  std::int64_t low = 0; ///< Require
  std::int64_t high = 0;
};

struct Assignment {
  CellId target = 0;
  NodeId value = 0;
  bool checked = false; ///< the value may leave the target's range
};

/// Compares some bits of a packed state with constants.
struct BitTest {
  std::uint32_t word = 0;
  Word mask = 0;
  Word value = 0;
  bool equal = true;
};

/// Writes constants to some bits of a packed state.
struct BitStore {
  std::uint32_t word = 0;
  Word keep = 0;
  Word bits = 0;
};

enum class InstructionKind : std::uint8_t {
  Assign,     // assignments[first, last): evaluates all values, then writes all targets
  Store,      // an Assign of constants as stores[firstStore, lastStore), once states have a layout
  On,         // the path is disabled unless node holds
  JumpUnless, // to instruction `last` unless node
  Jump,       // to instruction `last`
  Tag,        // event happens
  Origin,     // what follows comes from the origin `first`
  Fail,       // the model fails with the fault of node
  To,         // end of the path: assignments[first] sets the location; event of entering; leaf
  Loop,       // end of the path: leaf
};

struct Instruction {
  InstructionKind kind = InstructionKind::Loop;
  NodeId node = 0;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  std::uint32_t firstStore = 0;
  std::uint32_t lastStore = 0;
  EventId event = kNone;
  std::uint32_t leaf = 0; ///< J in the name `process_K_tJ` that frac gives
};

/// A condition on the way into a path whose evaluation may cause a fault.
struct Risk {
  NodeId node = 0; ///< true if the fault occurs when the condition is evaluated
  NodeId value = 0;
  fiacre::OriginId origin = 0;
};

/// One way through the statement of a `from`: an atomic step of one instance.
struct Path {
  InstanceId instance = 0;
  std::uint32_t location = 0;
  NodeId guard = 0; ///< conjunction of the `on` before the first assignment
  /// Has an `on` after an assignment, so only running the path shows whether it is enabled.
  bool tentative = false;
  bool loops = false; ///< ends in `loop`
  std::optional<fiacre::Interval> wait;
  std::uint32_t port = kNone;
  /// The values that it sends on its port, over the state before the path.
  std::vector<NodeId> sent;
  bool receives = false; ///< its code contains Received nodes
  std::vector<Instruction> code;
  std::vector<Assignment> assignments;
  std::vector<BitStore> stores;
  Bits guardReads;      ///< cells of the guard, including the location
  Bits reads;           ///< cells that the code may read
  Bits writes;          ///< cells that the code may write, including the location
  bool mayFail = false; ///< an assignment may leave its range, or an evaluation may cause a fault
  std::vector<Risk> risks; ///< of the guard
  bool fails = false;      ///< if this path is enabled, the model has an error
  fiacre::OriginId origin = 0;
  std::uint32_t group = 0;  ///< of an `unless`: a path of a later group has priority over this one
  std::uint32_t select = 0; ///< index of that `unless` within the process; 0: none
};

/// A silent path, or the paths of several instances that synchronise on a port, together with the
/// paths of the observers that move because they watch this step.
struct Transition {
  std::vector<PathId> parts; ///< by instance; observers come last
  std::uint32_t port = kNone;
  std::vector<EventId> events; ///< of the port, and events that observers pass
  /// Conditions of the observers that move, over the step and the states around it.
  std::vector<NodeId> seen;
  TransitionId unseen = kNone; ///< the same transition without observers; it has the clock of both
  fiacre::Interval interval;
  bool urgent = false;   ///< [0,0]
  ClockId clock = kNone; ///< kNone: urgent, or [0,...[
  NodeId guard = 0;      ///< conjunction of the locations and guards of all parts
  /// The guard as bit tests, once states have a layout; all must be true.
  std::vector<BitTest> tests;
  std::vector<NodeId> rest; ///< the conditions of the guard that are not bit tests; all must be
                            ///< true
  bool tentative = false;
  bool fails = false; ///< if this transition is enabled, the model has an error
  /// A part reads what another one writes, so each part reads the state before the step.
  bool apart = false;
  Bits consumed; ///< instances that do not end in `loop`
  /// Transitions with priority: this one is blocked while one of them is enabled.
  std::vector<TransitionId> blockers;
  /// Timed transitions with priority: this one is blocked once one of them has reached its lower
  /// bound.
  std::vector<TransitionId> laterBlockers;
  bool blocksLater = false; ///< it is one of the laterBlockers of another
  Bits guardReads;          ///< cells on which it depends whether the transition is enabled
  Bits reads;
  Bits writes;
};

/// A clock of the transitions of one instance's location, which are always enabled together, or of
/// one transition.
struct Clock {
  InstanceId instance = kNone;     ///< of a shared clock
  TransitionId transition = kNone; ///< of a clock of its own
};

struct Instance {
  std::string name; ///< `skill_takeoff_1`: the process and the number of its instance
  std::vector<std::string> locations;
  CellId location = 0;
  fiacre::OriginId origin = 0;
  std::vector<fiacre::OriginId> locationOrigins;
};

/// How a variable is named that the user watches, and how its values are printed.
struct WatchedCell {
  std::string display;
  CellId cell = 0;
  /// Names of the values, from the cell's low on; empty: the value is printed as a number.
  std::vector<std::string> words;
};

/// A ground of an origin (see fiacre::Origin), as an expression over cells.
struct GroundNode {
  fiacre::OriginId origin = 0;
  std::uint32_t index = 0; ///< in the origin's list of grounds
  NodeId node = 0;
};

struct System {
  std::vector<Cell> cells;
  std::vector<Node> nodes;
  /// Descriptions of the faults.
  std::vector<std::string> faults{"", "a division by zero", "a number beyond 2^62"};
  std::vector<Instance> instances;
  std::vector<std::string> ports;
  bool hasPriorities = false; ///< some transition has blockers or is observed
  std::vector<Path> paths;
  std::vector<Transition> transitions;
  std::vector<Clock> clocks;
  std::vector<WatchedCell> watched;
  std::vector<GroundNode> grounds; ///< ascending by origin
  std::uint32_t eventCount = 0;
  std::uint32_t words = 0; ///< of a packed state
  /// The first of these, by which the exploration distinguishes states.
  std::uint32_t storedWords = 0;
};

} // namespace proskill::verify
