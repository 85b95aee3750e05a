#pragma once

#include "fiacre/provenance.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The tree of Fiacre V3 and of H-Fiacre, its executable extension: what the code generator builds
/// and what the printer and the verifier read. Times are naturals of the model's unit. Berthomieu
/// et al., "The syntax and semantics of Fiacre" (V2, V3).
namespace proskill::fiacre {

struct Interval {
  std::int64_t lower = 0;
  std::optional<std::int64_t> upper; ///< nothing: unbounded
  bool lowerOpen = false;
  bool upperOpen = false; ///< of a bounded interval
  friend bool operator==(const Interval&, const Interval&) = default;
};

enum class TypeKind : std::uint8_t { Bool, Nat, Int, Range, Record, Array, Union, Queue, Named };

struct Type;

/// A field of a record, or a constructor of a union (whose type may be absent).
struct Member {
  std::string name;
  std::vector<Type> type; ///< none or one
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
  Name,        // name: variable, constant or constructor, as the type checker finds
  Construct,   // name(operands): a constructor with a value, or a call of a function
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

enum class StatementKind : std::uint8_t {
  Null,
  Comment,  // a line for the reader alone
  Assign,   // targets := values (any number of each, the same)
  Any,      // targets[0] := any [where values[0]]
  On,       // on values[0]
  Wait,     // wait interval
  To,       // to name
  Loop,     // stay in the state, clocks go on
  If,       // if values[0] then children[0] [else children[1]]; elsif is a nested If
  Case,     // case values[0] of patterns: values[1 + i] -> children[i]
  Select,   // children, by [] ; `unless` before child i where i is in priorityGroups
  Sequence, // children
  Send,     // name ! values…; without values a plain synchronisation
  Receive,  // name ? targets… [where values[0]]
  Tag,      // #name: the transitions that pass here bear it
  Start,    // H-Fiacre: start name(values…)
  Sync,     // H-Fiacre: sync name [targets[0]]
  While,    // while values[0] do children[0] end
  Foreach,  // foreach name do children[0] end
  Return,   // in functions: return values[0]
};

struct Statement {
  StatementKind kind = StatementKind::Null;
  OriginId origin = 0;
  std::string comment; ///< printed before it, at the end of its line where short
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

/// What can be seen of a model at a moment. A path is 1-based places in `par`, from the main
/// component down, or from an observer.
struct Observable {
  ObservableKind kind = ObservableKind::State;
  std::string observer; ///< that the path begins with; empty: the model
  std::vector<std::uint32_t> path;
  std::string name;
  Expr value;
  std::vector<Observable> operands;
  friend bool operator==(const Observable&, const Observable&) = default;
};

/// Whether it is of steps: whether a tag, an event, `enter` or `leave` is in it.
[[nodiscard]] bool watchesSteps(const Observable& observable);

/// What crosses a port; `sync` is no value at all.
struct Port {
  std::string name;
  std::vector<Type> values;
  bool in = false;
  bool out = false;
  std::optional<Interval> interval; ///< in components; nothing: [0,...[
  std::optional<Observable> probe;  ///< in components: what has to be seen for it to be passed
  OriginId origin = 0;              ///< of the probe
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

/// What can happen in a state: each path through the statement is one atomic transition.
struct From {
  std::string state;
  Statement statement;
  std::string comment; ///< the lines above, naming the program's line
  OriginId origin = 0; ///< of a model by hand: all of it
  friend bool operator==(const From&, const From&) = default;
};

struct Process {
  std::string name;
  OriginId origin = 0;
  std::string comment;
  std::vector<Port> ports;
  std::vector<Parameter> parameters;
  std::vector<State> states; ///< the first is the initial one, unless `init` says another
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

/// `P[ports](arguments)` in a component, or a composition within its composition; an argument that
/// is a reference is a plain variable's name.
struct Instance {
  std::string process;
  std::vector<std::string> ports;
  std::vector<Expr> arguments;
  std::vector<bool> references; ///< which arguments are passed by reference
  /// The component's ports on which it waits for the others; nothing: all that it is given.
  std::optional<std::vector<std::string>> synchronised;
  std::vector<Instance> parts; ///< of a composition, which has no process
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

/// `OBSERVER > MODEL`: the component runs beside the model, and goes before it.
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
  Progress, // not of Fiacre: time can always go on; printed as a comment
  NoError,  // likewise: nothing fails at run time
};

enum class LtlKind : std::uint8_t { Atom, Globally, Finally, Next, Until, Not, And, Or, Implies };

struct Ltl {
  LtlKind kind = LtlKind::Atom;
  Observable atom;
  std::vector<Ltl> operands;
  friend bool operator==(const Ltl&, const Ltl&) = default;
};

struct Pattern {
  PatternKind kind = PatternKind::Absent;
  /// What is absent, always, …; LeadsTo, Precedes: two; DeadlockFree: where it may stop, if
  /// anywhere.
  std::vector<Observable> operands;
  std::optional<Observable> after;
  std::optional<Observable> before;
  std::optional<Observable> until; ///< ends what `after` begins, again and again
  bool between = false;            ///< `between AFTER and UNTIL`: only where the end comes
  bool first = false;              ///< LeadsTo: the first one after it
  std::optional<Interval> within;
  std::optional<Interval> forInterval;
  std::optional<std::int64_t> forDuration;
  std::optional<std::int64_t> lasting;
  Ltl ltl;
  friend bool operator==(const Pattern&, const Pattern&) = default;
};

/// Whether a run without end may be what violates the pattern: what it wants never comes.
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
  bool asserted = true; ///< it is asked for, not only given a name
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

/// H-Fiacre: a port that a function of C offers.
struct EventPort {
  Port port;
  std::string function;
  friend bool operator==(const EventPort&, const EventPort&) = default;
};

/// H-Fiacre: a function of C that runs in a thread of its own.
struct Task {
  std::string name;
  std::vector<Type> parameters;
  Type result;
  std::string function;
  friend bool operator==(const Task&, const Task&) = default;
};

/// H-Fiacre: a function of C that is called within a transition.
struct Extern {
  std::string name;
  std::vector<Type> parameters;
  Type result;
  std::string function;
  friend bool operator==(const Extern&, const Extern&) = default;
};

/// Printed in this order.
struct Program {
  std::string comment; ///< the head of the file
  std::vector<Constant> constants;
  std::vector<TypeDeclaration> types;
  std::vector<EventPort> eventPorts;
  std::vector<Task> tasks;
  std::vector<Extern> externs;
  std::vector<Function> functions;
  std::vector<Process> processes;
  std::vector<Component> components;
  std::string main; ///< the component that is the model
  std::vector<Attachment> observers;
  std::vector<Property> properties;
  friend bool operator==(const Program&, const Program&) = default;
};

} // namespace proskill::fiacre
