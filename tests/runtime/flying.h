#pragma once

#include <string>

namespace proskill::test {

/// A skill that takes time, may be interrupted, and has a guard.
inline const std::string kFly = R"(
  (defsv sky :states (Clear Stormy) :init Clear :transitions :all)
  (defsv motors :states (Off On) :init Off :transitions ((Off On) (On Off)))
  (defevent storm :effects (sky Stormy))
  (defskill fly
    :start (motors On)
    :invariant (calm (:guard (sky Clear) :effects (motors Off)))
    :time_interval [2,5]
    :action (fly)
    :interrupt (:effects (motors Off))
    :success there (:effects (motors Off) :postcondition (sky Clear))
    :failure lost)
)";

/// A mission with this body, and the skill.
inline std::string mission(const std::string& body, const std::string& fields = "") {
  return kFly + "(defskill mission " + fields + " :success done :failure failed :body (" + body +
         "))";
}

} // namespace proskill::test
