"""A problem for planners that know no times: each skill runs from its start to its end in one step."""

from __future__ import annotations

from typing import Any, Dict, List


def without_times(problem: Any) -> None:
    """Replaces the durative actions. What must hold over all of an action must hold after the effects of its start;
    the verifier says what may happen between them."""
    from unified_planning.model import DurativeAction

    actions = list(problem.actions)
    problem.clear_actions()
    for action in actions:
        problem.add_action(in_one_step(action, problem) if isinstance(action, DurativeAction) else action)


def in_one_step(action: Any, problem: Any) -> Any:
    from unified_planning.model import InstantaneousAction

    step = InstantaneousAction(action.name)
    started = values_after({}, effects_at(action, at_start=True), problem)
    for interval, conditions in action.conditions.items():
        is_at_start = interval.lower == interval.upper and interval.lower.is_from_start()
        for each in conditions:
            needed = each if is_at_start else each.substitute(started).simplify()
            if not needed.is_true():
                step.add_precondition(needed)
    for fluent, value in values_after(started, effects_at(action, at_start=False), problem).items():
        if value != fluent:
            step.add_effect(fluent, value)
    return step


def effects_at(action: Any, at_start: bool) -> List[Any]:
    return [each for timing, some in action.effects.items() if timing.is_from_start() == at_start for each in some]


def values_after(before: Dict[Any, Any], effects: List[Any], problem: Any) -> Dict[Any, Any]:
    """The value of each fluent that effects have changed, in terms of the state before the action. Those of one moment
    happen together."""
    manager = problem.environment.expression_manager
    after = dict(before)
    for effect in effects:
        value = effect.value.substitute(before)
        if effect.is_increase() or effect.is_decrease():
            known = before.get(effect.fluent, effect.fluent)
            opposite: Any = known.args if known.is_plus() or known.is_minus() else ()
            if len(opposite) == 2 and opposite[1] == value and known.is_minus() == effect.is_increase():
                value = opposite[0]  # what the start has taken, and the end gives back
            else:
                value = (manager.Plus if effect.is_increase() else manager.Minus)(known, value)
        after[effect.fluent] = value
    return after
