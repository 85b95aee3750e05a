"""Plans, verifies, and gives the planner what the verifier has found, until a plan is verified."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from typing import Dict, List, Optional, Set, Tuple

from proskill.planning.order import block_of, useful_steps
from proskill.planning.pddl import (Action, Domain, Impossible, Refused, Undecided, domain_of, problem_of, terms_of,
                                    words_of)
from proskill.planning.planner import Planned, run_planner
from proskill.planning.reach import can_reach
from proskill.planning.skill import in_words, main_of, skill_of

MOST_ROUNDS = 20
FIRST_SECONDS = 5  # for the verifier, before a planner is asked


@dataclass
class Settings:
    proskill: str
    program: str
    goal: str
    planners: List[str]
    outcomes: str = "best"
    seconds: float = 60
    megabytes: int = 4096
    name: str = "plan"


@dataclass
class Finding:
    """A property that a plan violates, with the steps that lead to it."""

    description: str
    summary: str
    subject: str
    kind: str
    steps: List[dict] = field(default_factory=list)  # type: ignore[type-arg]


def say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


class Loop:
    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.domain: Domain = domain_of(settings.proskill, settings.program, settings.outcomes)
        self.problem = problem_of(settings.proskill, settings.program, settings.goal)
        self.constraints: List[Tuple[str, str]] = []
        self.verifier = ""  # what it says about the goal

    def run(self) -> str:
        """The text of a skill that the verifier accepts."""
        self.verifier = self.refuse_impossible(min(FIRST_SECONDS, self.settings.seconds))
        for number in range(1, MOST_ROUNDS + 1):
            plan, planner = self.plan()
            plan = self.without_useless(plan)
            actions = [self.domain.actions[each.action] for each in plan]
            if not plan:
                raise Refused("the goal holds from the start: no plan is needed")
            block = block_of(plan, actions)
            say(f"plan {number}, by {planner}: {times_in_words(plan)}\n  its order: {in_words(block)}")
            skill = skill_of(self.domain, self.settings.name, block)
            finding = self.verified(skill, actions)
            if finding is None:
                say("  verified: every run in which the actions succeed reaches the goal")
                return skill
            say(f"  not verified: {finding.description}\n  {finding.summary}")
            self.learn(finding, actions)
        raise Undecided(f"no plan was verified in {MOST_ROUNDS} rounds")

    # --- Planning

    def refuse_impossible(self, seconds: float) -> str:
        """Ends with an error if no order of skills reaches the goal. Otherwise, what the verifier says of it."""
        possible, reason = can_reach(self.domain, self.settings, seconds)
        if possible is None:
            return f"undecided: {reason}"
        if possible:
            return "there may be one: an order of skills, some of which may fail, reaches the goal"
        raise Impossible("the goal is impossible: no order of basic skills and events reaches it, says the verifier")

    def asked_again(self) -> str:
        """What the verifier says about the goal within the whole limit of time."""
        if self.verifier.startswith("undecided"):
            self.verifier = self.refuse_impossible(self.settings.seconds)
        return self.verifier

    def plan(self) -> Tuple[List[Planned], str]:
        domain = self.domain.with_constraints(self.constraints)
        problems = []
        for planner in self.settings.planners:
            limits = (self.settings.seconds, self.settings.megabytes)
            answer = run_planner(planner, domain, self.problem, *limits)
            if answer.status == "solved":
                return answer.plan, planner
            if answer.status == "unsolvable":
                because = f" under {len(self.constraints)} constraints" if self.constraints else ""
                raise Undecided(f"no plan reaches the goal{because}, says {planner}\n  verifier: {self.asked_again()}")
            problems.append(f"{planner}: {answer.words}")
        problems.append(f"verifier: {self.asked_again()}")
        raise Undecided("no planner has found a plan\n  " + "\n  ".join(problems))

    def without_useless(self, plan: List[Planned]) -> List[Planned]:
        actions = [self.domain.actions[each.action] for each in plan]
        goal = next(part[1] for part in terms_of(self.problem)[0] if part[0] == ":goal")
        running = {atom for atom, words in self.domain.atoms.items() if words.endswith((" is idle", " left"))}
        return [plan[i] for i in useful_steps(plan, actions, words_of(goal), running)] if plan else []

    # --- Verification

    def verified(self, skill: str, actions: List[Action]) -> Optional[Finding]:
        """What is wrong with a skill in the environment of its plan; None if nothing is."""
        with tempfile.TemporaryDirectory(prefix="proskill-plan-") as folder:
            path = os.path.join(folder, "plan.proskill")
            with open(path, "w", encoding="utf-8") as file:
                file.write(program_with(self.settings, skill, self.world(actions), folder))
            report = verify(self.settings.proskill, path, main_of(self.settings.name, skill))
        rows = [row for row in report["properties"] if self.matters(row, actions)]
        for row in rows:
            if row["verdict"] == "inconclusive":
                raise Undecided(f"the verifier cannot decide this: {row['description']}")
        bad = [row for row in rows if not self.wanted(row)]
        return finding_of(bad[0]) if bad else None

    def world(self, actions: List[Action]) -> str:
        """The environment in which a plan is judged, unless the program has one of its own."""
        return "" if self.domain.has_environment else world_of(actions)

    def matters(self, row: Dict[str, object], actions: List[Action]) -> bool:
        skills = {each.skill for each in actions}
        if row["name"] in ("plan_reaches_goal", "plan_can_succeed"):
            return True
        if row["kind"] == "invariant_may_fail":
            return row["subject"] in skills
        return row["kind"] in ("never_refused", "no_forbidden_transition", "time_progress")

    @staticmethod
    def wanted(row: Dict[str, object]) -> bool:
        """No invariant may fail; everything else has to be as the verifier expects it."""
        if row["kind"] == "invariant_may_fail":
            return row["verdict"] == "unreachable"
        return bool(row["good"])

    # --- Constraints

    def learn(self, finding: Finding, actions: List[Action]) -> None:
        """Two skills that disturb each other must not run at the same time."""
        pair = self.culprits(finding, {each.skill for each in actions if each.skill})
        if pair is None:
            raise Undecided("no constraint avoids this: it is not the work of two skills of the plan")
        if pair in self.constraints:
            raise Undecided("the planner has been told this already: no plan of this kind can be verified")
        self.constraints.append(pair)
        say(f"  constraint {len(self.constraints)}: `{pair[0]}` and `{pair[1]}` must not run at the same time")

    def culprits(self, finding: Finding, skills: Set[str]) -> Optional[Tuple[str, str]]:
        victim = self.victim(finding, skills)
        if victim is None:
            return None
        for number in re.findall(r"since step (\d+)", finding.summary):
            reason = finding.steps[int(number) - 1]["actor"]
            if reason in skills and reason != victim:
                one, other = sorted((victim, reason))
                return one, other
        variables = self.variables_of(victim, finding.kind == "property")
        for step in reversed(finding.steps):
            changed = {change["variable"] for change in step["changes"]} & variables
            if not changed or step["actor"] == victim:
                continue
            if step["actor"] in skills:
                one, other = sorted((victim, step["actor"]))
                return one, other
            variables -= changed  # by the environment, which no constraint holds back
        return None

    def variables_of(self, skill: str, with_effects: bool) -> Set[str]:
        actions = [each for each in self.domain.actions.values() if each.skill == skill]
        atoms = set().union(*(each.reads() for each in actions))
        if with_effects:
            atoms = atoms.union(*(each.writes() for each in actions))
        return {self.variable(atom) for atom in atoms}

    def victim(self, finding: Finding, skills: Set[str]) -> Optional[str]:
        """The skill that a plan has let down: it failed, was refused, or ended before the goal was missed."""
        if finding.kind == "invariant_may_fail":
            return finding.subject
        for step in reversed(finding.steps):
            if step["actor"] in skills:
                return str(step["actor"])
        return None

    def variable(self, atom: str) -> str:
        words = self.domain.atoms.get(atom, "")
        return words.strip("()").split(" ")[0]


def times_in_words(plan: List[Planned]) -> str:
    in_order = sorted(plan, key=lambda it: it.start)
    return ", ".join(f"{each.action} [{float(each.start):g}, {float(each.end):g}]" for each in in_order)


def world_of(actions: List[Action]) -> str:
    """An environment in which the events of a plan occur, in its order, besides those that come by themselves."""
    emits = [f"(^ [0,...[) (emit {each.event})" for each in actions if each.event and not each.comes_by_itself]
    return f"(defenvironment planned\n  :body ({' '.join(emits) or '(^ 0)'}))\n"


def program_with(settings: Settings, skill: str, world: str, folder: str) -> str:
    program = os.path.relpath(os.path.realpath(settings.program), os.path.realpath(folder))
    return (f"(include \"{program}\")\n\n{skill}\n{world}\n"
            f"(defproperty plan_reaches_goal\n  (never (and (ended {settings.name} success) (not {settings.goal}))))\n"
            f"(defproperty plan_can_succeed (reachable (ended {settings.name} success)))\n")


def verify(proskill: str, path: str, main: str) -> dict:  # type: ignore[type-arg]
    command = [proskill, "verify", "--format", "json", "--traces", "all", "--main", main, path]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if not done.stdout.startswith("{"):
        raise Refused(f"the plan cannot be verified: {done.stderr.strip()}")
    report = json.loads(done.stdout)
    assert isinstance(report, dict)
    return report


def finding_of(row: dict) -> Finding:  # type: ignore[type-arg]
    trace = row["trace"] or {"summary": "", "steps": []}
    words = f"{row['description']}: {row['verdict']}"
    return Finding(words, trace["summary"], row["subject"], row["kind"], trace["steps"])
