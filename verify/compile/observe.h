#pragma once

#include "verify/compile/elaborate.h"
#include "verify/model/goals.h"

namespace proskill::verify {

/// Turns properties into goals. Observables of locations and tags become events where possible;
/// others become conditions on states and steps.
class Observer {
public:
  Observer(const fiacre::Program& program, const Elaboration& model, Expressions& expressions,
           Events& events, System& system);

  /// \throw CompileError if the property names something that the model does not have
  [[nodiscard]] Goal goal(const fiacre::Property& property);
  /// The condition under which the observable holds in a state or a step.
  NodeId node(const fiacre::Observable& observable);

private:
  std::optional<Goal> goalOfStates(const fiacre::Pattern& pattern);
  Goal goalOfRuns(const fiacre::Ltl& ltl);
  Goal duration(GoalKind kind, const fiacre::Pattern& pattern);
  Goal reach(const fiacre::Observable& observable);
  bool simple(const fiacre::Observable& observable, Goal& goal);
  NodeId joined(const fiacre::Observable& observable, NodeOp op);
  NodeId stateNode(const fiacre::Observable& observable);
  NodeId valueNode(const fiacre::Observable& observable);
  NodeId happens(const std::vector<EventId>& of);
  [[nodiscard]] InstanceId instance(const fiacre::Observable& observable) const;
  [[nodiscard]] std::uint32_t location(const fiacre::Observable& observable) const;
  std::vector<EventId> tagEvents(const fiacre::Observable& observable);
  EventId portEvent(const fiacre::Observable& observable);

  const fiacre::Program& program;
  const Elaboration& model;
  Expressions& expressions;
  Events& events;
  System& system;
};

} // namespace proskill::verify
