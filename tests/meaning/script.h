#pragma once

#include "analysis/program/program.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// A second semantics of ProSkill: an interpreter that follows docs/language.md and
/// docs/semantics.md. It uses nothing of codegen/, fiacre/ or verify/, which it is to check.
namespace proskill::meaning {

inline constexpr int kNobody = -1;
inline constexpr int kRoot = -2; ///< calls the mission, monitors, and a library's skills

/// A place in a body at which control can be.
struct Place {
  const syntax::Statement* statement = nullptr; ///< null: the end of the body
  const syntax::Statement* call = nullptr;      ///< Call: the call; Case: the one at its beginning
  int next = 0;                                 ///< the place after the statement
  std::vector<int> targets;  ///< WaitCondition: the timeout; If, Case: by arm; While, DoUntil: the
                             ///< body; Choose: by branch
  std::vector<int> branches; ///< Parallel, Race: threads
};

/// Executes statements: a composite skill, a parallel branch of one, or the environment.
struct Thread {
  int skill = kNobody;     ///< the composite skill; nobody: the environment
  int parent = kNobody;    ///< of a branch: the thread with the `//`
  std::vector<int> rivals; ///< of a branch of a race: the others
  std::vector<Place> places;
  int entry = 0;
  std::map<std::string_view, int> labels;
  std::set<int> calls;   ///< skills that it calls itself
  bool holdsOut = false; ///< one of these does, or a branch

  [[nodiscard]] bool isBranch() const { return parent != kNobody; }
};

/// An input of a skill that conditions or effects may depend on.
struct InputEntry {
  std::string_view name; ///< with its `$`
  int variable = 0;      ///< the state variable whose values it has; nobody: a truth value
};

/// A skill that can run in the program.
struct SkillEntry {
  const syntax::Skill* node = nullptr;
  int body = kNobody;          ///< composite: its thread
  bool root = false;           ///< it is called when the program starts
  bool calledByAnyone = false; ///< of a library: it may be called at any time
  std::set<int> callers;       ///< threads
  bool holdsOut = false;       ///< whoever stops it may have to wait
  std::vector<InputEntry> inputs;

  [[nodiscard]] bool isComposite() const { return body != kNobody; }
  [[nodiscard]] bool startsItself() const { return root && callers.empty(); }
  /// It may have several callers, so it may be busy.
  [[nodiscard]] bool isShared() const {
    return callers.size() + (root || calledByAnyone ? 1U : 0U) > 1;
  }
};

/// A program prepared for interpretation. Refers to the program.
struct Script {
  const analysis::Program* program = nullptr;
  std::vector<const syntax::StateVariable*> variables;
  std::vector<const syntax::Event*> events;
  std::vector<const syntax::Resource*> resources;
  std::vector<SkillEntry> skills;
  std::vector<Thread> threads;
  int mission = kNobody;
  int environment = kNobody; ///< thread; nobody: every event and interrupt at any time
  std::int64_t unitsPerSecond = 1;
  /// The translation makes steps beside those of events: an event with `:every` first becomes due,
  /// and a forbidden move is noted after it.
  bool eventsMakeSteps = false;
  /// Where an input is read: the skill and which of its inputs it is.
  std::map<const syntax::Expr*, std::pair<int, int>> parameters;

  [[nodiscard]] int skill(std::string_view name) const; ///< nobody: it never runs
  [[nodiscard]] int variable(std::string_view name) const;
  [[nodiscard]] int event(std::string_view name) const;
  /// Ages of threads, then of skills, then of events.
  [[nodiscard]] int clockOfEvent(int event) const {
    return static_cast<int>(threads.size() + skills.size()) + event;
  }
  [[nodiscard]] std::int64_t units(const syntax::Rational& seconds) const {
    return seconds.numerator * (unitsPerSecond / seconds.denominator);
  }
};

/// Whether it ends after its `duration`, or then does something else.
[[nodiscard]] bool waitsForTime(const syntax::Statement& statement);

/// \pre the program has no errors
/// \return nullopt if the mission is ambiguous
[[nodiscard]] std::optional<Script> scriptOf(const analysis::Program& program);

} // namespace proskill::meaning
