#pragma once

#include "syntax/text/rational.h"
#include "syntax/text/source.h"
#include "syntax/tree/arena.h"

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The typed tree. It is total: a half-typed program gives a tree with missing parts (empty names,
/// expressions of kind Missing), and every existing part has its exact range. Views refer to text
/// that the tree's document keeps alive.
namespace proskill::syntax {

/// A word of the program. If it is missing, the text is empty, and the range is where it was
/// expected.
struct Name {
  std::string_view text;
  Range range;

  explicit operator bool() const { return !text.empty(); }
};

/// An interval of seconds as written: `[1,3]`, `]0,0.5[`, `[2,...[`.
struct Interval {
  Rational lower;
  std::optional<Rational> upper; ///< nullopt: unbounded
  bool lowerOpen = false;
  bool upperOpen = false; ///< true if unbounded
  Range range;
  /// The constants that the bounds are written as. In a document their values are not known: the
  /// bounds are 0 and unbounded.
  Name lowerName{};
  Name upperName{};
};

enum class ExprKind : std::uint8_t {
  Missing, // missing or not understood
  True,
  False,
  Number,    // number; name: the constant that it is written as
  Symbol,    // name: a state variable, a value of one, a status, an outcome's tag, or a constant
  String,    // text, without its quotes
  Parameter, // name, with its `$`
  Access,    // name.member
  Test,      // (name operands[0])
  Equal,
  NotEqual,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  And,
  Or,
  Not,
  Implies,
  Equivalent,
  Add,
  Subtract,
  // Only in properties:
  Running, // (running name)
  Called,  // (called name)
  Ended,   // (ended name [member])
  Occurs,  // (occurs name)
  At,      // (at name)
  Value,   // (value name operands[0])
  Globally,
  Finally,
  Next,
  Until,
  WeakUntil,
  Release,
  StrongRelease,
};

/// A condition, a value, or an argument.
struct Expr {
  ExprKind kind = ExprKind::Missing;
  Range range;
  Name head;   ///< the operator as written, if there is one
  Name name;   ///< see ExprKind
  Name member; ///< Access: `status`, `res`, …; Ended: the status
  Rational number;
  bool decimal = false; ///< Number: written with a point
  List<Expr> operands;
};

/// `(variable value)`.
struct Effect {
  Name variable;
  Expr value;
  Range range;
};

struct Effects {
  List<Effect> items;
  Range range;
};

/// A keyword with its values, in the order of the text. Used to find missing, repeated and
/// misplaced keywords.
struct FieldUse {
  Name keyword; ///< with its colon
  Range range;  ///< keyword and value
};

struct Transition {
  Name from;
  Name to;
  Range range;
};

/// `(defconst NAME NUMBER)`.
struct Constant {
  Name name;
  Expr value; ///< a Number, or Missing
};

enum class Transitions : std::uint8_t { Unstated, All, Listed };

struct StateVariable {
  Name name;
  List<FieldUse> fields;
  List<Name> states;
  Expr init;             ///< the first of several
  List<Expr> otherInits; ///< `:init (A B)`: it may be any of these, too
  std::optional<Expr> min;
  std::optional<Expr> max;
  Transitions transitionsKind = Transitions::Unstated;
  List<Transition> transitions;

  [[nodiscard]] bool isNatural() const { return min || max; }
  /// From the first initial value to the last one.
  [[nodiscard]] Range initRange() const {
    return otherInits.empty() ? init.range : Range{init.range.begin, otherInits.back().range.end};
  }
};

struct Event {
  Name name;
  List<FieldUse> fields;
  std::optional<Interval> every; ///< between two occurrences, and from the start to the first
  std::optional<Expr> guard;     ///< the event occurs only while it holds
  Effects effects;
};

struct Resource {
  Name name;
  List<FieldUse> fields;
  std::optional<Expr> capacity; ///< default: 1
};

struct Input {
  Name name; ///< with its `$`
  Name type;
  Range range;
};

struct Precondition {
  Name tag;
  Expr condition;
  Range range;
};

struct Invariant {
  Name tag;
  Expr guard;
  Effects effects;
  Range range;
};

struct Outcome {
  Name tag;
  Effects effects;
  std::optional<Range> postconditionField; ///< keyword and value
  std::optional<Expr> postcondition;
  Range range;
};

struct Action {
  Name command;
  List<Expr> arguments;
  Range range;
};

struct Interrupt {
  Effects effects;
  Range range;
};

struct Statement;

struct Block {
  List<Statement> statements;
  Range range;
};

/// The outcomes of a call that an arm of a `case` covers.
struct CasePattern {
  Name status;     ///< `success`, `failure`, `failed_inv`, `interrupted`, `refused`, or `else`
  List<Name> tags; ///< any of these; empty: any tag
  Range range;
};

/// A branch of an `if` or `case`. In an `if`, `if` and `elseif` have a condition, `else` has none.
/// In a `case`, the pattern selects outcomes of the call; `else` has no pattern.
struct Arm {
  Range keyword;
  std::optional<Expr> condition;
  CasePattern pattern; ///< Case
  Block body;
};

/// An argument of a call has a name and a value, an argument of a printf only a value.
struct Argument {
  Name name;
  Expr value;
  Range range;
};

enum class StatementKind : std::uint8_t {
  Unknown,       // not understood; a diagnostic has been reported
  Call,          // (name arguments…)
  Interrupt,     // (name.interrupt)
  WaitCondition, // (^ condition [:effects effects] [:timeout duration branches[0]])
  WaitTime,      // (^ duration)
  If,            // arms
  Case,          // branches[0]: the call alone; arms
  While,         // condition, branches[0]
  DoUntil,       // branches[0], condition
  Break,
  Label,    // name
  Goto,     // name
  Parallel, // branches
  Race,     // branches
  Set,      // effects
  Printf,   // format, arguments
  Success,  // name: the tag
  Failure,  // name: the tag
  Emit,     // name: the event
  Choose,   // branches
};

struct Statement {
  StatementKind kind = StatementKind::Unknown;
  Range range;
  Name head; ///< the word that determines the kind of statement; for a call, the skill
  Name name;
  Name format; ///< of a printf, without its quotes
  List<Argument> arguments;
  Expr condition;
  Interval duration;
  Effects effects;
  List<Arm> arms;
  List<Block> branches;
};

struct Skill {
  Name name;
  List<FieldUse> fields;
  List<Input> inputs;
  List<Precondition> preconditions;
  Effects start;
  List<Invariant> invariants;
  std::optional<Interval> timeInterval;
  std::optional<Action> action;
  std::optional<Interrupt> interrupt; ///< or `:interruptible t`
  /// `:interruptible nil`: while it runs, nothing can interrupt or stop it.
  bool unstoppable = false;
  List<Outcome> successes;
  List<Outcome> failures;
  List<Name> resources;
  bool monitor = false;
  bool armed = false; ///< `:monitor always`: starts whenever its precondition begins to hold
  std::optional<Block> body;

  [[nodiscard]] bool isComposite() const { return body.has_value(); }
};

enum class PropertyKind : std::uint8_t {
  Missing,
  Always,
  Never,
  Reachable,
  DeadlockFree,
  InfinitelyOften,
  LeadsTo,
  Precedes,
  Present,
  Absent,
  AlwaysReachable,
  Longest,
  Shortest,
  Ltl,
};

struct Property {
  Name name;
  PropertyKind kind = PropertyKind::Missing;
  Range bodyRange;
  Name head;
  List<Expr> operands; ///< P, then Q
  List<FieldUse> fields;
  std::optional<Expr> after;
  std::optional<Expr> before;
  std::optional<Interval> within;
  std::optional<Interval> forDuration;
  std::optional<Expr> lasting; ///< seconds
  std::optional<bool> fair;    ///< whether only fair runs count; absent: the default
  List<Name> fairSkills;       ///< fair: skills whose actions and waits end; empty: all skills
};

struct Environment {
  Name name;
  List<FieldUse> fields;
  Block body;
};

struct Include {
  Name path; ///< without its quotes
};

/// Names the file that says who performs the actions of the program.
struct Platform {
  Name path; ///< without its quotes
};

/// A form at the top level that the language does not have. A diagnostic has been reported.
struct UnknownForm {
  Name head;
  Name name; ///< the word after it: what it would have defined
};

using FormNode = std::variant<UnknownForm, Include, Platform, Constant, StateVariable, Event, Skill,
                              Resource, Property, Environment>;

/// The statements of a body that are needed in all bodies after each edit, outer before inner, in
/// the order of the text.
struct BodyIndex {
  List<const Statement*> calls;
  List<const Statement*> labels;
  List<const Statement*> parallels;
};

struct ReadForm;

/// A form with the numbers in place of a program's constants, see constants.h.
struct FilledForm {
  std::shared_ptr<const std::string> constants; ///< what identifies their names and numbers
  std::shared_ptr<const ReadForm> form;         ///< null: the form mentions no constant
};

/// The filled form that was made last: most edits leave both the form and the constants as they
/// were. Thread-safe. Copies begin empty.
class LastFilled {
public:
  LastFilled() = default;
  LastFilled(const LastFilled&) noexcept {}
  LastFilled& operator=(const LastFilled&) = delete;

  [[nodiscard]] FilledForm get() const {
    const std::scoped_lock lock(mutex);
    return last;
  }
  void set(FilledForm filled) const {
    const std::scoped_lock lock(mutex);
    last = std::move(filled);
  }

private:
  mutable std::mutex mutex;
  mutable FilledForm last;
};

/// A form at the top level, with ranges as parsed.
struct ReadForm {
  Range range;  ///< from its opening to its closing parenthesis
  Name keyword; ///< `defskill`, …
  /// A parenthesis or quote was inserted or removed, so the form is a guess.
  bool recovered = false;
  FormNode node;
  BodyIndex bodyIndex; ///< of its body, if it has one
  LastFilled lastFilled{};
};

} // namespace proskill::syntax
