#pragma once

#include "analysis/program/program.h"

#include <map>
#include <set>

namespace proskill::bridge::bt {

/// Who changes a state variable.
enum class Changed : std::uint8_t {
  Freely,   // by events alone, to any state at any time: a condition of the tree
  Never,    // it has any of its states for ever: a condition, too
  ByBodies, // by the bodies of composite skills alone: an entry of the blackboard
  Otherwise // by skills, or in another way that only a leaf can know
};

/// The state variables of a program, as a tree sees them.
class Variables {
public:
  explicit Variables(const analysis::Program& program);

  /// \pre the program has the variable
  [[nodiscard]] Changed changed(std::string_view variable) const;
  /// The only variable that an event changes, or nothing.
  [[nodiscard]] static std::string_view onlyVariableOf(const syntax::Event& event);

private:
  void skill(const syntax::Skill& skill);
  void effects(const syntax::Effects& effects, std::set<std::string_view>& variables);
  [[nodiscard]] bool isFree(const syntax::StateVariable& variable) const;

  const analysis::Program& program;
  std::set<std::string_view> byBodies;
  std::set<std::string_view> bySkills; ///< by the effects that skills declare
  std::set<std::string_view> byEvents;
  std::set<std::string_view> restricted; ///< by events with a guard, times or several effects
  std::map<std::string_view, std::set<std::string_view>> free; ///< states by other events
};

} // namespace proskill::bridge::bt
