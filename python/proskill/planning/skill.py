"""Writes the order of a plan as a composite skill."""

from __future__ import annotations

from collections import Counter
from typing import List, Set

from proskill.planning.order import Block, Parallel, Sequence, Step
from proskill.planning.pddl import Domain, atoms_true_in


class SkillWriter:
    def __init__(self, domain: Domain, name: str) -> None:
        self.domain = domain
        self.name = name
        self.inputs: List[str] = []
        self.failures: Set[str] = set()
        self.calls: "Counter[str]" = Counter()

    def write(self, block: Block) -> str:
        body = self.statements(block, 5)
        inputs = f"\n  :input ({' '.join(self.inputs)})" if self.inputs else ""
        failures = f"\n  :failure ({' '.join(sorted(self.failures))})" if self.failures else ""
        lines = "\n".join(body + ["     (success reached)"])
        skill = f"(defskill {self.name}{inputs}\n  :success reached{failures}\n  :body\n    ({lines.lstrip()}))\n"
        return skill + start_of(self.domain, self.name, self.inputs)

    def statements(self, block: Block, depth: int) -> List[str]:
        space = " " * depth
        if isinstance(block, Step):
            return [space + line for line in self.step(block)]
        if isinstance(block, Sequence):
            return [line for part in block.parts for line in self.statements(part, depth)]
        branches = ["\n".join(self.statements(part, depth + 5)).lstrip() for part in block.parts]
        inner = ("\n" + space + "    ").join(f"({branch})" for branch in branches)
        return [f"{space}(// {inner})"]

    def step(self, step: Step) -> List[str]:
        action = step.action
        if action.event:
            made = [atom for atom in map(atoms_true_in, action.effects) if atom]
            conditions = [self.domain.atoms[atom] for atom in made]
            return [wait(conditions)]
        return self.waits(step) + self.call(step)

    def waits(self, step: Step) -> List[str]:
        """A wait for what a skill that is still running has made true, and this step needs."""
        conditions = [text for text in map(self.domain.condition, step.awaited) if text]
        return [wait(list(dict.fromkeys(conditions)))] if conditions else []

    def call(self, step: Step) -> List[str]:
        action = step.action
        call = f"({action.skill}{self.arguments(step)})"
        if action.is_only:
            return [call]
        failure = f"{action.skill}_failed"
        self.failures.add(failure)
        arm = f"(({action.status} {action.tag}))" if action.tag else f"({action.status})"
        return [f"(case {call}", f"   {arm}", f"   (else (failure {failure})))"]

    def arguments(self, step: Step) -> str:
        self.calls[step.action.skill] += 1
        count = self.calls[step.action.skill]
        text = "".join(f" {name} {value}" for name, value in step.action.values)
        for name, kind in step.action.inputs:
            own = f"{step.action.skill}{'' if count == 1 else count}_{name}"
            self.inputs.append(f"${own} {kind}")
            text += f" {name} ${own}"
        return text


def start_of(domain: Domain, name: str, inputs: List[str]) -> str:
    """A mission has no inputs. If a skill has some, this one calls it, with a value for each."""
    if not inputs:
        return ""
    pairs = [each[1:].split(" ") for each in inputs]
    values = "".join(f" {one} {domain.example(one, kind)}" for one, kind in pairs)
    return f"\n; Nothing that is verified depends on these values: write yours.\n(defskill {name}_start\n  :body\n    (({name}{values})))\n"


def main_of(name: str, text: str) -> str:
    """The mission of a program with a skill."""
    return f"{name}_start" if f"(defskill {name}_start\n" in text else name


def wait(conditions: List[str]) -> str:
    return f"(^ {conditions[0] if len(conditions) == 1 else '(and ' + ' '.join(conditions) + ')'})"


def skill_of(domain: Domain, name: str, block: Block) -> str:
    return SkillWriter(domain, name).write(block)


def in_words(block: Block) -> str:
    """A block on one line: `a, (b | c), d`."""
    if isinstance(block, Step):
        return block.action.event or " ".join([block.action.skill] + [value for _, value in block.action.values])
    words = [f"({in_words(part)})" if isinstance(part, Parallel) else in_words(part) for part in block.parts]
    return (", " if isinstance(block, Sequence) else " | ").join(words)
