#pragma once

#include "analysis/program/program.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// A second meaning of ProSkill: programs are interpreted as docs/language.md and docs/semantics.md
/// describe them. Nothing here uses codegen/, fiacre/ or verify/, which it is to judge.
namespace proskill::meaning {

inline constexpr int kNobody = -1;
inline constexpr int kRoot = -2; ///< who calls the mission, monitors, and a library's skills

/// A place in a body at which control can stand.
struct Place {
  const syntax::Statement* statement = nullptr; ///< null: the end of the body
  const syntax::Statement* call = nullptr;      ///< Call: itself; Case: the one that it begins with
  int next = 0;                                 ///< the place behind the statement
  std::vector<int> targets;  ///< WaitCondition: the timeout; If, Case: by arm; While, DoUntil: the
                             ///< body; Choose: by branch
  std::vector<int> branches; ///< Parallel, Race: threads
};

/// Who executes statements: a composite skill, a parallel branch of one, or the environment.
struct Thread {
  int skill = kNobody;     ///< the composite skill; nobody: the environment
  int parent = kNobody;    ///< of a branch: the thread with the `//`
  std::vector<int> rivals; ///< of a branch of a race: the others, if any
  std::vector<Place> places;
  int entry = 0;
  std::map<std::string_view, int> labels;
  std::set<int> calls;   ///< the skills that it calls itself
  bool holdsOut = false; ///< one of these does, or a branch

  [[nodiscard]] bool isBranch() const { return parent != kNobody; }
};

/// A skill that can run in the program.
struct SkillEntry {
  const syntax::Skill* node = nullptr;
  int body = kNobody;          ///< composite: its thread
  bool root = false;           ///< it is called when the program starts
  bool calledByAnyone = false; ///< a library's: it may be called at any time
  std::set<int> callers;       ///< threads
  bool holdsOut = false;       ///< who stops it may have to wait

  [[nodiscard]] bool isComposite() const { return body != kNobody; }
  [[nodiscard]] bool runsOnce() const { return root && callers.empty(); }
  /// More than one may call it, so it may be busy.
  [[nodiscard]] bool isShared() const {
    return callers.size() + (root || calledByAnyone ? 1U : 0U) > 1;
  }
};

/// A program taken apart, ready to be interpreted. It looks into the program.
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

  [[nodiscard]] int skill(std::string_view name) const; ///< nobody: it never runs
  [[nodiscard]] int variable(std::string_view name) const;
  [[nodiscard]] int event(std::string_view name) const;
  /// Ages are of threads, then of skills, then of events.
  [[nodiscard]] int clockOfEvent(int event) const {
    return static_cast<int>(threads.size() + skills.size()) + event;
  }
  [[nodiscard]] std::int64_t units(const syntax::Rational& seconds) const {
    return seconds.numerator * (unitsPerSecond / seconds.denominator);
  }
};

/// It ends when its `duration` is over, or does something else then.
[[nodiscard]] bool waitsForTime(const syntax::Statement& statement);

/// \pre the program has no errors. Nothing where it is not clear which skill is the mission.
[[nodiscard]] std::optional<Script> scriptOf(const analysis::Program& program);

} // namespace proskill::meaning
