#pragma once

#include "fiacre/provenance.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The tree of Fiacre V3 and its executable extension H-Fiacre. The code generator builds it; the
/// printer and the verifier read it. Times are naturals in the model's unit. Berthomieu et al.,
/// "The syntax and semantics of Fiacre" (V2, V3).
namespace proskill::fiacre {

struct Interval {
  std::int64_t lower = 0;
  std::optional<std::int64_t> upper; ///< nullopt: unbounded
  bool lowerOpen = false;
  bool upperOpen = false; ///< if bounded
  friend bool operator==(const Interval&, const Interval&) = default;
};

enum class TypeKind : std::uint8_t { Bool, Nat, Int, Range, Record, Array, Union, Queue, Named };

struct Type;

/// A field of a record, or a constructor of a union (whose type may be absent).
struct Member {
  std::string name;
  std::vector<Type> type; ///< zero or one
  std::string comment;
  friend bool operator==(const Member&, const Member&) = default;
};

struct Type {
  TypeKind kind = TypeKind::Bool;
  std::string name;            ///< Named
  std::int64_t low = 0;        ///< Range
  std::int64_t high = 0;       ///< Range
  std::vector<Member> members; ///< Record, Union
  std::int64_t size = 0;       ///< Array, Queue
  std::vector<Type> element;   ///< Array, Queue: one
  friend bool operator==(const Type&, const Type&) = default;
};

enum class ExprKind : std::uint8_t {
  Bool,        // number 0 or 1
  Number,      // number
  Name,        // name: a variable, constant or constructor; the type checker decides
  Construct,   // name(operands): a constructor with a value, or a function call
  Unary,       // op operands[0]
  Binary,      // operands[0] op operands[1]
  Conditional, // operands[0] ? operands[1] : operands[2]
  Index,       // operands[0][operands[1]]
  Field,       // operands[0].name
  Array,       // [operands…]
  Record,      // {fields[i] = operands[i], …}
  Queue,       // {|operands…|}
};

enum class Op : std::uint8_t {
  Not,
  Negate,
  Coerce,
  Empty,
  Full,
  First,
  Dequeue, // unary
  And,
  Or,
  Equal,
  NotEqual,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Add,
  Subtract,
  Multiply,
  Divide,
  Modulo,
  Enqueue,
  Append,
};

struct Expr {
  ExprKind kind = ExprKind::Bool;
  Op op = Op::Not;
  std::int64_t number = 0;
  std::string name;
  std::vector<std::string> fields;
  std::vector<Expr> operands;
  friend bool operator==(const Expr&, const Expr&) = default;
};

/// The pattern `any`, which every value matches.
[[nodiscard]] inline bool isWild(const Expr& pattern) {
  return pattern.kind == ExprKind::Name && pattern.name == "any";
}

enum class StatementKind : std::uint8_t {
  Null,
  Comment,  // a line of comment
  Assign,   // targets := values (the same number of each)
  Any,      // targets[0] := any [where values[0]]
  On,       // on values[0]
  Wait,     // wait interval
  To,       // to name
  Loop,     // stays in the state without resetting clocks
  If,       // if values[0] then children[0] [else children[1]]; elsif is a nested If
  Case,     // case values[0] of patterns: values[1 + i] -> children[i]
  Select,   // children, separated by []; `unless` before child i if i is in priorityGroups
  Sequence, // children
  Send,     // name ! values…; without values: only synchronisation
  Receive,  // name ? targets… [where values[0]]
  Tag,      // #name: a tag of the transitions through this statement
  Start,    // H-Fiacre: start name(values…)
  Sync,     // H-Fiacre: sync name [targets[0]]
  While,    // while values[0] do children[0] end
  Foreach,  // foreach name do children[0] end
  Return,   // in functions: return values[0]
};

struct Statement {
  StatementKind kind = StatementKind::Null;
  OriginId origin = 0;
  std::string comment; ///< printed before it, or at the end of its line if short
  std::string name;
  std::vector<Expr> targets;
  std::vector<Expr> values;
  Interval interval;
  std::vector<Statement> children;
  std::vector<std::size_t> priorityGroups;
  friend bool operator==(const Statement&, const Statement&) = default;
};

struct Variable {
  std::string name;
  Type type;
  std::optional<Expr> init;
  std::string comment;
  friend bool operator==(const Variable&, const Variable&) = default;
};

enum class ObservableKind : std::uint8_t {
  State, // path/state name
  Value, // path/value expr
  Tag,   // path/tag name
  Event, // path/event name
  Enter,
  Leave,
  Not,
  And,
  Or,
  Implies,
};

/// Something observable in a model at a moment. Its path consists of 1-based positions in `par`,
/// from the main component, or from an observer.
struct Observable {
  ObservableKind kind = ObservableKind::State;
  std::string observer; ///< the observer at which the path begins; empty: the model
  std::vector<std::uint32_t> path;
  std::string name;
  Expr value;
  std::vector<Observable> operands;
  friend bool operator==(const Observable&, const Observable&) = default;
};

/// Whether it observes steps: it contains a tag, an event, `enter` or `leave`.
[[nodiscard]] bool watchesSteps(const Observable& observable);

/// The channel of a port; `sync`: no values.
struct Port {
  std::string name;
  std::vector<Type> values;
  bool in = false;
  bool out = false;
  std::optional<Interval> interval; ///< in components; nullopt: [0,...[
  std::optional<Observable> probe; ///< in components: the condition under which the port is enabled
  OriginId origin = 0;             ///< of the probe
  std::string comment;
  friend bool operator==(const Port&, const Port&) = default;
};

struct Parameter {
  std::string name;
  Type type;
  bool reference = false;
  friend bool operator==(const Parameter&, const Parameter&) = default;
};

struct State {
  std::string name;
  OriginId origin = 0;
  friend bool operator==(const State&, const State&) = default;
};

/// The transitions of a state: each path through the statement is one atomic transition.
struct From {
  std::string state;
  Statement statement;
  std::string comment; ///< the lines above, which name the program's line
  OriginId origin = 0; ///< if the user wrote the model: all of it
  friend bool operator==(const From&, const From&) = default;
};

struct Process {
  std::string name;
  OriginId origin = 0;
  std::string comment;
  std::vector<Port> ports;
  std::vector<Parameter> parameters;
  std::vector<State> states; ///< the first is the initial one, unless `init` sets another
  std::vector<Variable> variables;
  std::optional<Statement> init;
  std::vector<From> transitions;
  friend bool operator==(const Process&, const Process&) = default;
};

struct Function {
  std::string name;
  std::string comment;
  std::vector<Parameter> parameters;
  Type result;
  std::vector<Variable> variables;
  Statement body;
  friend bool operator==(const Function&, const Function&) = default;
};

/// `P[ports](arguments)` in a component, or a nested composition. An argument passed by reference
/// is the name of a variable.
struct Instance {
  std::string process;
  std::vector<std::string> ports;
  std::vector<Expr> arguments;
  std::vector<bool> references; ///< which arguments are passed by reference
  /// The component's ports on which it synchronises; nullopt: all of its ports.
  std::optional<std::vector<std::string>> synchronised;
  std::vector<Instance> parts; ///< of a nested composition, which has no process
  friend bool operator==(const Instance&, const Instance&) = default;
};

struct Priority {
  std::vector<std::string> higher;
  std::vector<std::string> lower;
  friend bool operator==(const Priority&, const Priority&) = default;
};

/// A parallel composition. An instance that does not synchronise on a port passes it alone.
struct Component {
  std::string name;
  std::string comment;
  std::vector<Port> interfacePorts;
  std::vector<Parameter> parameters;
  std::vector<Variable> variables;
  std::vector<Port> ports;
  std::vector<Priority> priorities;
  std::optional<Statement> init;
  std::vector<Instance> instances;
  friend bool operator==(const Component&, const Component&) = default;
};

/// `OBSERVER > MODEL`: the observer runs in parallel with the model and has priority over it.
struct Attachment {
  std::string observer;
  std::string model;
  OriginId origin = 0;
  friend bool operator==(const Attachment&, const Attachment&) = default;
};

enum class PatternKind : std::uint8_t {
  DeadlockFree,
  InfinitelyOften,
  Mortal,
  Present,
  Absent,
  Always,
  LeadsTo,
  Precedes,
  Ltl,
  // Not in Fiacre, printed as comments:
  Progress,        // time can always pass
  NoError,         // no evaluation fails at run time
  AlwaysReachable, // from every state, some run leads to the operand
  Longest,         // a value: the longest time from the first operand to the next second one
  Shortest,        // the same, the shortest time
};

[[nodiscard]] inline bool isOfFiacre(PatternKind kind) { return kind < PatternKind::Progress; }
/// Whether the answer is a time rather than a truth value.
[[nodiscard]] inline bool asksForTime(PatternKind kind) {
  return kind == PatternKind::Longest || kind == PatternKind::Shortest;
}

enum class LtlKind : std::uint8_t { Atom, Globally, Finally, Next, Until, Not, And, Or, Implies };

struct Ltl {
  LtlKind kind = LtlKind::Atom;
  Observable atom;
  std::vector<Ltl> operands;
  friend bool operator==(const Ltl&, const Ltl&) = default;
};

struct Pattern {
  PatternKind kind = PatternKind::Absent;
  /// The operands of `absent`, `always`, …; LeadsTo, Precedes: two; DeadlockFree: where deadlocks
  /// are allowed, if anywhere.
  std::vector<Observable> operands;
  std::optional<Observable> after;
  std::optional<Observable> before;
  std::optional<Observable> until; ///< ends the scope of `after`, repeatedly
  bool between = false;            ///< `between AFTER and UNTIL`: only if UNTIL follows
  bool first = false;              ///< LeadsTo: only the first one after it counts
  std::optional<Interval> within;
  std::optional<Interval> forInterval;
  std::optional<std::int64_t> forDuration;
  std::optional<std::int64_t> lasting;
  Ltl ltl;
  friend bool operator==(const Pattern&, const Pattern&) = default;
};

/// Whether an infinite run may violate the pattern, because what it requires never happens.
[[nodiscard]] inline bool isAboutEndlessRuns(const Pattern& pattern) {
  const auto bounded = [](const std::optional<Interval>& interval) {
    return interval && interval->upper;
  };
  if (bounded(pattern.within) || bounded(pattern.forInterval)) return false;
  return pattern.kind == PatternKind::Present || pattern.kind == PatternKind::LeadsTo ||
         pattern.kind == PatternKind::InfinitelyOften || pattern.kind == PatternKind::Mortal ||
         pattern.kind == PatternKind::Ltl;
}

struct Property {
  std::string name;
  Pattern pattern;
  OriginId origin = 0;
  std::string comment;
  bool asserted = true; ///< it is to be checked, not only named
  friend bool operator==(const Property&, const Property&) = default;
};

struct TypeDeclaration {
  std::string name;
  Type type;
  std::string comment;
  friend bool operator==(const TypeDeclaration&, const TypeDeclaration&) = default;
};

struct Constant {
  std::string name;
  Type type;
  Expr value;
  friend bool operator==(const Constant&, const Constant&) = default;
};

/// H-Fiacre: a port that a function in C offers.
struct EventPort {
  Port port;
  std::string function;
  friend bool operator==(const EventPort&, const EventPort&) = default;
};

/// H-Fiacre: a function in C with its own thread.
struct Task {
  std::string name;
  std::vector<Type> parameters;
  Type result;
  std::string function;
  friend bool operator==(const Task&, const Task&) = default;
};

/// H-Fiacre: a function in C that a transition calls.
struct Extern {
  std::string name;
  std::vector<Type> parameters;
  Type result;
  std::string function;
  friend bool operator==(const Extern&, const Extern&) = default;
};

/// Printed in this order.
struct Program {
  std::string comment; ///< the comment at the top of the file
  std::vector<Constant> constants;
  std::vector<TypeDeclaration> types;
  std::vector<EventPort> eventPorts;
  std::vector<Task> tasks;
  std::vector<Extern> externs;
  std::vector<Function> functions;
  std::vector<Process> processes;
  std::vector<Component> components;
  std::string main; ///< the main component
  std::vector<Attachment> observers;
  std::vector<Property> properties;
  friend bool operator==(const Program&, const Program&) = default;
};

} // namespace proskill::fiacre
