"""The order of a plan, without its times."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import List, Set, Tuple, Union

from proskill.planning.pddl import Action, Term, words_of
from proskill.planning.planner import Planned


@dataclass
class Step:
    action: Action
    number: int  # in the plan
    awaited: List[Term] = field(default_factory=list)  # conditions that a skill beside it makes true


@dataclass
class Sequence:
    parts: List["Block"]


@dataclass
class Parallel:
    parts: List["Block"]


Block = Union[Step, Sequence, Parallel]


def interfere(one: Action, other: Action) -> bool:
    """Whether one changes what the other reads or changes."""
    return bool(one.writes() & (other.reads() | other.writes()) or one.reads() & other.writes())


def order_of(plan: List[Planned], actions: List[Action]) -> Set[Tuple[int, int]]:
    """Pairs of steps that must happen one after the other: they interfere, and the plan has them in this order."""
    before = set()
    for i, earlier in enumerate(plan):
        for j, later in enumerate(plan):
            follows = earlier.end <= later.start and (earlier.start, i) < (later.start, j)
            if i != j and follows and interfere(actions[i], actions[j]):
                before.add((i, j))
    for k in range(len(plan)):  # the transitive closure; S. Warshall, 1962
        for i in range(len(plan)):
            for j in range(len(plan)):
                if (i, k) in before and (k, j) in before:
                    before.add((i, j))
    return before


def awaited_by(later: int, plan: List[Planned], actions: List[Action]) -> List[Term]:
    """Conditions of a step that the starts of skills change which still run when it begins."""
    begin = plan[later].start
    beside = [action for each, action in zip(plan, actions) if each.start < begin < each.end and action.skill]
    changed = set().union(*(action.starts() for action in beside), set())
    own = actions[later].start + actions[later].overall
    return [term for term in own if words_of(term) & changed]


def useful_steps(plan: List[Planned], actions: List[Action], goal: Set[str], running: Set[str]) -> List[int]:
    """The steps from which causal links lead to the goal: a planner that looks for any plan may add others.

    goal: the atoms that it reads; running: atoms that say whether a skill runs or what it holds, which are as at the
    beginning wherever a step is omitted."""
    kept: Set[int] = set()
    wanted = [(goal, max(each.end for each in plan) + 1, -1)]
    while wanted:
        atoms, date, reader = wanted.pop()
        for step in set().union(*(writers_before(date, atom, plan, actions) for atom in atoms - running), set()):
            if step != reader and step not in kept:
                kept.add(step)
                overall = set().union(*(words_of(each) for each in actions[step].overall), set())
                wanted += [(actions[step].reads(), plan[step].start, step), (overall, plan[step].end, step)]
    return sorted(kept)


def writers_before(date: Fraction, atom: str, plan: List[Planned], actions: List[Action]) -> Set[int]:
    """The steps that give an atom its value at a date: the last to end, and those that run then. All that count."""
    all_of_them = {i for i, each in enumerate(plan) if each.start < date and atom in actions[i].writes()}
    counts = any(effect[0] in ("increase", "decrease", "assign") and atom in words_of(effect[1])
                 for i in all_of_them for effect in actions[i].effects)
    last = max((plan[i].end for i in all_of_them if plan[i].end <= date), default=None)
    return {i for i in all_of_them if counts or plan[i].end > date or plan[i].end == last}


def block_of(plan: List[Planned], actions: List[Action]) -> Block:
    """A plan as a block of sequences and parallel branches that keeps its order."""
    before = order_of(plan, actions)
    steps = sorted(range(len(plan)), key=lambda i: (plan[i].start, plan[i].end, i))
    return arranged(steps, before, [Step(action, i, awaited_by(i, plan, actions)) for i, action in enumerate(actions)])


def arranged(steps: List[int], before: Set[Tuple[int, int]], leaves: List[Step]) -> Block:
    if len(steps) == 1:
        return leaves[steps[0]]
    parts = components(steps, before)
    if len(parts) > 1:
        return Parallel([arranged(part, before, leaves) for part in parts])
    for k in range(1, len(steps)):
        first, rest = lower_set(steps, before, k)
        if rest and all((i, j) in before for i in first for j in rest):
            return joined(arranged(first, before, leaves), arranged(rest, before, leaves))
    # no series-parallel order: the steps that nothing precedes come first, which only adds order
    first = [i for i in steps if not any((j, i) in before for j in steps)]
    rest = [i for i in steps if i not in first]
    return joined(arranged(first, before, leaves), arranged(rest, before, leaves))


def lower_set(steps: List[int], before: Set[Tuple[int, int]], count: int) -> Tuple[List[int], List[int]]:
    """At least `count` steps with all that precede them, and the rest."""
    first = set(steps[:count])
    first |= {i for i in steps for j in first if (i, j) in before}
    return [i for i in steps if i in first], [i for i in steps if i not in first]


def joined(first: Block, rest: Block) -> Sequence:
    parts: List[Block] = []
    for block in (first, rest):
        parts += block.parts if isinstance(block, Sequence) else [block]
    return Sequence(parts)


def components(steps: List[int], before: Set[Tuple[int, int]]) -> List[List[int]]:
    """Steps between which there is no order, not even through others."""
    parts: List[List[int]] = []
    for step in steps:
        near = [part for part in parts if any((i, step) in before or (step, i) in before for i in part)]
        parts = [part for part in parts if part not in near] + [sorted(sum(near, [step]), key=steps.index)]
    return parts
