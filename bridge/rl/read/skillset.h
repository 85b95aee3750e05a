#pragma once

#include "bridge/text/word.h"

#include <optional>
#include <utility>

/// Skillsets of the robot language (RL) of ONERA, as they are written.
namespace proskill::bridge::rl {

enum class ExprKind : std::uint8_t { True, False, Is, IsNot, Not, And, Or, Implies };

/// A condition. `Is` and `IsNot` compare a resource with a state.
struct Expr {
  ExprKind kind = ExprKind::True;
  Word resource;
  Word state;
  std::vector<Expr> operands;
};

struct Effect {
  Word resource;
  Word state;
};
using Effects = std::vector<Effect>;

/// A datum, an input or an output.
struct Variable {
  Word name;
  std::string type;
};

struct Resource {
  Word name;
  std::vector<Word> states;
  Word initial;
  bool allMoves = false;
  std::vector<std::pair<Word, Word>> moves;
};

struct Event {
  Word name;
  std::optional<Expr> guard;
  Effects effects;
};

struct Precondition {
  Word name;
  Expr condition;
};

struct Invariant {
  Word name;
  Expr guard;
  Effects effects;
};

struct Outcome {
  Word name;
  Effects effects;
  std::optional<Expr> postcondition;
};

struct Interrupt {
  Place place;
  bool lasts = false; ///< `interrupting true`: the skill may go on for a while
  Effects effects;
  std::optional<Expr> postcondition;
};

struct Skill {
  Word name;
  std::vector<Variable> parameters;
  std::vector<Variable> inputs;
  std::vector<Variable> outputs;
  std::vector<Precondition> preconditions;
  Effects start;
  std::vector<Invariant> invariants;
  std::optional<Place> progress;
  std::optional<Interrupt> interrupt;
  std::vector<Outcome> successes;
  std::vector<Outcome> failures;
};

struct Skillset {
  Word name;
  std::vector<Variable> parameters;
  std::vector<Variable> data;
  std::vector<Resource> resources;
  std::vector<Event> events;
  std::vector<Skill> skills;
};

} // namespace proskill::bridge::rl
