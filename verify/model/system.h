#pragma once

#include "fiacre/syntax/tree.h"
#include "verify/model/bits.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The transition system of a model: what `verify/` explores. Made by compile() from the tree;
/// every variable is a bit field of a packed state, every path through a `from` a straight piece of
/// code.
namespace proskill::verify {

using Word = std::uint64_t;
using CellId = std::uint32_t;
using NodeId = std::uint32_t;
using PathId = std::uint32_t;
using TransitionId = std::uint32_t;
using InstanceId = std::uint32_t;
using ClockId = std::uint32_t;
using EventId = std::uint32_t;
using FaultId = std::uint32_t; ///< in System::faults

inline constexpr std::uint32_t kNone = UINT32_MAX;

/// Faults that every system has.
inline constexpr FaultId kNoFault = 0;
inline constexpr FaultId kDivisionByZero = 1;
inline constexpr FaultId kOverflow = 2;

/// A scalar variable, or the state that an instance is in.
struct Cell {
  std::string name;
  std::int64_t low = 0;
  std::int64_t high = 0;
  std::int64_t initial = 0;
  std::uint32_t word = 0; ///< where it stands in a packed state
  std::uint32_t shift = 0;
  Word mask = 0; ///< of its bits, in place
};

enum class NodeOp : std::uint8_t {
  Number, // number
  Cell,   // cell a
  Test,   // (word a & mask) == value; made of comparisons with constants when the state is laid out
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
  Happens,     // event a, in the step that is watched
  Entered,
  Left,     // a becomes true, false by the step
  Received, // the a-th part of what a port brings; put in when parts are brought together
  Require,  // b where a; else the fault c. `number` tells that `low` and `high` limit b then
  Fails,    // whether evaluating a comes to a fault
};

/// An expression over cells. Nodes are shared: equal expressions are the same node.
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

/// A comparison of some bits of a packed state with constants.
struct BitTest {
  std::uint32_t word = 0;
  Word mask = 0;
  Word value = 0;
  bool equal = true;
};

/// Constants for some bits of a packed state.
struct BitStore {
  std::uint32_t word = 0;
  Word keep = 0;
  Word bits = 0;
};

enum class InstructionKind : std::uint8_t {
  Assign, // assignments[first, last): all values first, then all targets
  Store, // an Assign of constants as stores[firstStore, lastStore), made when the state is laid out
  On,    // give the path up unless node
  JumpUnless, // to instruction `last` unless node
  Jump,       // to instruction `last`
  Tag,        // event
  Origin,     // first is the origin
  Fail,       // a fault of the model: what evaluating node comes to
  To,         // ends: assignments[first] is that of the location, event of entering, leaf
  Loop,       // ends: leaf
};

struct Instruction {
  InstructionKind kind = InstructionKind::Loop;
  NodeId node = 0;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  std::uint32_t firstStore = 0;
  std::uint32_t lastStore = 0;
  EventId event = kNone;
  std::uint32_t leaf = 0; ///< J of frac's name `process_K_tJ`
};

/// A condition on the way into a path that may come to a fault.
struct Risk {
  NodeId node = 0; ///< it is looked at, and comes to a fault
  NodeId value = 0;
  fiacre::OriginId origin = 0;
};

/// One way through the statement of a `from`: an atomic step of one instance.
struct Path {
  InstanceId instance = 0;
  std::uint32_t location = 0;
  NodeId guard = 0; ///< every `on` before the first assignment
  bool tentative =
      false;          ///< has an `on` after an assignment: only running it tells if it is enabled
  bool loops = false; ///< ends in `loop`
  std::optional<fiacre::Interval> wait;
  std::uint32_t port = kNone;
  std::vector<NodeId> sent; ///< what it puts on its port, over the state before the path
  bool receives = false;    ///< its code has Received nodes
  std::vector<Instruction> code;
  std::vector<Assignment> assignments;
  std::vector<BitStore> stores;
  Bits guardReads;         ///< cells of the guard, the location among them
  Bits reads;              ///< cells that the code may read
  Bits writes;             ///< cells that the code may write, the location among them
  bool mayFail = false;    ///< an assignment may leave its range, or a value may come to a fault
  std::vector<Risk> risks; ///< of the guard
  bool fails = false;      ///< it is an error of the model that this is enabled
  fiacre::OriginId origin = 0;
  std::uint32_t group = 0;  ///< of an `unless`: a path of a later group goes before this one
  std::uint32_t select = 0; ///< of that `unless`, within the process; 0: none
};

/// A silent path, or paths of several instances that synchronise on a port; with those of observers
/// that take part in the step because they watch for it.
struct Transition {
  std::vector<PathId> parts; ///< by instance; those of observers behind the others
  std::uint32_t port = kNone;
  std::vector<EventId> events; ///< of the port, and of those that observers pass
  /// What the step has to be for the observers that take part: over it and the states around it.
  std::vector<NodeId> seen;
  TransitionId unseen = kNone; ///< the same without observers: its clock is the one of both
  fiacre::Interval interval;
  bool urgent = false;        ///< [0,0]
  ClockId clock = kNone;      ///< nothing: urgent, or [0,...[
  NodeId guard = 0;           ///< locations and guards of all parts
  std::vector<BitTest> tests; ///< the guard, made when the state is laid out: all of these
  std::vector<NodeId> rest;   ///< and all of those
  bool tentative = false;
  bool fails = false; ///< it is an error of the model that this is enabled
  bool apart = false; ///< a part reads what another writes: each sees the state before the step
  Bits consumed;      ///< instances that do not end in `loop`
  std::vector<TransitionId> blockers; ///< none of which may be enabled: they have priority
  /// None of which may have reached its lower bound: likewise, with clocks.
  std::vector<TransitionId> laterBlockers;
  bool blocksLater = false; ///< it is one of the laterBlockers of another
  Bits guardReads;          ///< what being enabled depends on
  Bits reads;
  Bits writes;
};

/// A clock belongs to the transitions of an instance's location that are always enabled together,
/// or to one transition.
struct Clock {
  InstanceId instance = kNone;     ///< of a shared clock
  TransitionId transition = kNone; ///< of a clock of its own
};

struct Instance {
  std::string name; ///< `skill_takeoff_1`: the process and which instance of it
  std::vector<std::string> locations;
  CellId location = 0;
  fiacre::OriginId origin = 0;
  std::vector<fiacre::OriginId> locationOrigins;
};

/// What the model prints of a variable that the user watches.
struct WatchedCell {
  std::string display;
  CellId cell = 0;
  std::vector<std::string> words; ///< of the values from the cell's low on; empty: the number
};

/// A ground of an origin, as an expression over cells.
struct GroundNode {
  fiacre::OriginId origin = 0;
  std::uint32_t index = 0; ///< in the origin's grounds
  NodeId node = 0;
};

struct System {
  std::vector<Cell> cells;
  std::vector<Node> nodes;
  /// What can go wrong, in words.
  std::vector<std::string> faults{"", "a division by zero", "a number beyond 2^62"};
  std::vector<Instance> instances;
  std::vector<std::string> ports;
  bool hasPriorities = false; ///< some transition has blockers, or is observed
  std::vector<Path> paths;
  std::vector<Transition> transitions;
  std::vector<Clock> clocks;
  std::vector<WatchedCell> watched;
  std::vector<GroundNode> grounds; ///< by origin, ascending
  std::uint32_t eventCount = 0;
  std::uint32_t words = 0;       ///< of a packed state
  std::uint32_t storedWords = 0; ///< of these, those that the exploration tells apart
};

} // namespace proskill::verify
