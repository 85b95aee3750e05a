"""Whether any order of skills can reach a goal: a program that may start each skill at any time, and the verifier."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from typing import Dict, List, Optional, Tuple

from proskill.planning.pddl import Action, Domain
from proskill.planning.skill import main_of, start_of

Values = Tuple[Tuple[str, str], ...]  # names and values of the inputs that conditions and effects read


class AnyOrder:
    """The text of a program whose mission calls each basic skill again and again, at any time and with any values.
    Whatever a plan does, it can do."""

    def __init__(self, domain: Domain, name: str) -> None:
        self.domain = domain
        self.name = name
        self.choices: List[str] = []  # definitions
        self.events: List[str] = []
        self.inputs: List[str] = []

    def write(self, include: str, goal: str) -> str:
        calls = [call for skill, each in self.skills().items() for call in self.calls(skill, each)]
        branches = [f"(while true (^ [0,...[) {call})" for call in calls]
        body = f"(// ({') ('.join(branches)}))" if len(branches) > 1 else "".join(branches) or "(^ 0)"
        inputs = f" :input ({' '.join(self.inputs)})" if self.inputs else ""
        environment = "" if self.domain.has_environment else self.environment()
        start = start_of(self.domain, self.name, self.inputs)
        return (f"(include \"{include}\")\n{''.join(self.choices)}(defskill {self.name}{inputs} :body ({body}))\n"
                f"{start}{environment}(defproperty {self.name}_goal (reachable {goal}))\n")

    def environment(self) -> str:
        """All events, at any time, and no interrupts."""
        free = [each.event for each in self.domain.actions.values() if each.event and not each.comes_by_itself]
        emits = " ".join(f"((emit {event}))" for event in self.events + free)
        world = f"(while true (^ [0,...[) (choose {emits}))" if emits else "(^ 0)"
        return f"(defenvironment {self.name}_world :body ({world}))\n"

    def skills(self) -> Dict[str, List[Action]]:
        """The actions of each skill, one for each choice of values."""
        found: Dict[str, Dict[Values, Action]] = {}
        for action in self.domain.actions.values():
            if action.skill:
                found.setdefault(action.skill, {}).setdefault(tuple(action.values), action)
        return {skill: list(each.values()) for skill, each in found.items()}

    def calls(self, skill: str, actions: List[Action]) -> List[str]:
        """One call of any of the actions. A program with an environment has no other: there, each has its own."""
        own = self.own_inputs(skill, actions[0])
        calls = [f"({skill}{''.join(f' {name} {value}' for name, value in each.values)}{own})" for each in actions]
        if len(calls) == 1 or self.domain.has_environment:
            return calls
        variable = f"{self.name}_{skill}"
        states = [f"V{i}" for i in range(len(calls))]
        self.choices.append(f"(defsv {variable} :states ({' '.join(states)}) :init V0)\n")
        for state in states:
            self.choices.append(f"(defevent {variable}_{state} :effects ({variable} {state}))\n")
            self.events.append(f"{variable}_{state}")
        tests = [f"({variable} {state}) {call}" for state, call in zip(states, calls)]
        return [f"(if {' elseif '.join(tests)})"]

    def own_inputs(self, skill: str, action: Action) -> str:
        """Inputs that nothing reads become inputs of the mission."""
        self.inputs += [f"${skill}_{name} {kind}" for name, kind in action.inputs]
        return "".join(f" {name} ${skill}_{name}" for name, _ in action.inputs)


def can_reach(domain: Domain, settings, seconds: float) -> Tuple[Optional[bool], str]:  # type: ignore[no-untyped-def]
    """Whether some order reaches the goal; None with the reason where the verifier cannot decide it."""
    with tempfile.TemporaryDirectory(prefix="proskill-plan-") as folder:
        path = os.path.join(folder, "any-order.proskill")
        program = os.path.relpath(os.path.realpath(settings.program), os.path.realpath(folder))
        text = AnyOrder(domain, settings.name).write(program, settings.goal)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        main = main_of(settings.name, text)
        command = [settings.proskill, "verify", "--format", "json", "--traces", "none", "--main", main,
                   "--property", f"{settings.name}_goal", "--time-limit", str(max(1, int(seconds))),
                   "--memory-limit", str(settings.megabytes), path]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    try:
        rows = json.loads(done.stdout)["properties"]
        row = next(each for each in rows if each["kind"] == "property")  # others are of a variable with its name
    except (ValueError, KeyError, StopIteration):
        return None, (done.stderr.strip().splitlines() or ["no answer"])[0]
    if row["verdict"] == "inconclusive":
        return None, str(row.get("reason", ""))
    return row["verdict"] == "reachable", ""
