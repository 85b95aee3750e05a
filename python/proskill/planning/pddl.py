"""The domain and the problem that `proskill emit pddl` writes, as data."""

from __future__ import annotations

import re
import subprocess
from dataclasses import dataclass, field
from typing import Any, Dict, Iterator, List, Optional, Set, Tuple, Union

Term = Union[str, List["Term"]]


class Refused(Exception):
    """What a user has to change."""

    exit_code = 2


class Impossible(Refused):
    """No plan can reach the goal."""

    exit_code = 1


class Undecided(Refused):
    """No plan was found, although there may be one."""

    exit_code = 3


@dataclass
class Action:
    """A skill with one of its outcomes, or an event."""

    name: str
    skill: str = ""
    status: str = ""  # success, failure
    tag: str = ""
    is_only: bool = False  # the skill has no other outcome
    event: str = ""
    comes_by_itself: bool = False  # the event has `:every`
    inputs: List[Tuple[str, str]] = field(default_factory=list)  # name and type, for the caller to choose
    values: List[Tuple[str, str]] = field(default_factory=list)  # of the other inputs
    start: List[Term] = field(default_factory=list)  # conditions
    overall: List[Term] = field(default_factory=list)
    effects: List[Term] = field(default_factory=list)  # of the start and of the end
    start_effects: List[Term] = field(default_factory=list)

    def reads(self) -> Set[str]:
        return set().union(*(words_of(each) for each in self.start + self.overall), set())

    def starts(self) -> Set[str]:
        """What the start changes, besides that the skill runs and holds resources."""
        counted = [term for term in self.start_effects if term[0] not in ("increase", "decrease")]
        return set().union(*(words_of(each) for each in counted), set())

    def writes(self) -> Set[str]:
        return set().union(*(words_of(each) for each in self.effects), set())


def words_of(term: Term) -> Set[str]:
    """All atoms in a term: the heads of its innermost lists, and numbers."""
    if isinstance(term, str):
        return set()
    head = term[0] if term and isinstance(term[0], str) else ""
    if len(term) == 1 and head not in ("and", "or"):
        return {head}
    return set().union(*(words_of(each) for each in term), set())


def tokens_of(text: str) -> Iterator[str]:
    for line in text.splitlines():
        yield from re.findall(r"[()]|[^\s()]+", line.split(";")[0])


def terms_of(text: str) -> List[Term]:
    stack: List[List[Term]] = [[]]
    for token in tokens_of(text):
        if token == "(":
            stack.append([])
        elif token == ")":
            done = stack.pop()
            stack[-1].append(done)
        else:
            stack[-1].append(token)
    return stack[0]


class Domain:
    """The domain of a program, and what its comments say."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.atoms: Dict[str, str] = dict(re.findall(r"^ *\(([^\s()]+)\) ; (.+)$", text, re.M))
        self.actions: Dict[str, Action] = {}
        self.has_environment = re.search(r"^ *; environment ", text, re.M) is not None
        notes = re.findall(r"; (skill|event) (.+)\n +\(:(?:durative-)?action (\S+)", text)
        parts = {part[1]: part for part in terms_of(text)[0]
                 if isinstance(part, list) and part[0] in (":durative-action", ":action")}
        for kind, words, name in notes:
            self.actions[name] = action_of(kind, words, name, parts[name])

    def condition(self, term: Term) -> str:
        """A term in ProSkill; empty where it has no equivalent."""
        if isinstance(term, str):
            return term
        head = term[0] if term else ""
        if len(term) == 1 and isinstance(head, str) and head in self.atoms:
            return self.atoms[head]
        if head in ("and", "or") and len(term) == 1:
            return "true" if head == "and" else "false"
        parts = [self.condition(each) for each in term[1:]]
        return f"({head} {' '.join(parts)})" if all(parts) else ""

    def example(self, name: str, kind: str) -> str:
        """A value of a type, for an input that nothing reads."""
        known = {"string": f'"{name}"', "bool": "true"}
        values = [words[len(kind) + 2:-1] for words in self.atoms.values() if words.startswith(f"({kind} ")]
        return known.get(kind) or (values or ["0"])[0]

    def with_constraints(self, pairs: List[Tuple[str, str]]) -> str:
        """The domain in which no two skills of a pair run at the same time."""
        text = self.text
        for one, other in pairs:
            for skill, beside in ((one, other), (other, one)):
                for action in self.actions.values():
                    if action.skill == skill:
                        text = self._forbid(text, action.name, self.idle(beside))
        return text

    def idle(self, skill: str) -> str:
        for atom, words in self.atoms.items():
            if words == f"{skill} is idle":
                return atom
        raise Refused(f"`{skill}` is not a basic skill")

    @staticmethod
    def _forbid(text: str, name: str, atom: str) -> str:
        head = text.index(f"(:durative-action {name}\n")
        at = text.index(":condition (and", head) + len(":condition (and")
        return text[:at] + f"\n      (at start ({atom}))\n      (over all ({atom}))" + text[at:]


def pair(text: str, mark: str) -> Tuple[str, str]:
    first, _, second = text.partition(mark)
    return first, second


def action_of(kind: str, words: str, name: str, part: List[Term]) -> Action:
    action = Action(name)
    fields: Dict[Any, Any] = dict(zip(part[2::2], part[3::2]))
    if kind == "event":
        action.event, _, how = words.partition(" ")
        action.comes_by_itself = how == "by itself"
        action.start = [fields[":precondition"]]
        action.effects = fields[":effect"][1:]
        return action
    noted = re.fullmatch(r"(\S+) \((\S+?)(?: (\S+))?\)( only)?(.*)", words)
    assert noted, words
    action.skill, action.status, action.tag = noted[1], noted[2], noted[3] or ""
    action.is_only = bool(noted[4])
    action.inputs = [pair(each, ":") for each in noted[5].split() if "=" not in each]
    action.values = [pair(each, "=") for each in noted[5].split() if "=" in each]
    for timed in fields[":condition"][1:]:
        (action.overall if timed[0] == "over" else action.start).append(timed[2])
    action.effects = [timed[2] for timed in fields[":effect"][1:]]
    action.start_effects = [timed[2] for timed in fields[":effect"][2:] if timed[1] == "start"]  # after: not idle
    return action


def ask(command: List[str]) -> str:
    """What a command prints. What it reports on standard error is shown by itself."""
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise Refused("")
    return done.stdout


def domain_of(proskill: str, program: str, outcomes: str) -> Domain:
    return Domain(ask([proskill, "emit", "pddl", "--outcomes", outcomes, program]))


def problem_of(proskill: str, program: str, goal: str) -> str:
    return ask([proskill, "emit", "pddl", "--goal", goal, program])


def atoms_true_in(term: Term) -> Optional[str]:
    """The atom that an effect makes true."""
    return term[0] if isinstance(term, list) and len(term) == 1 and isinstance(term[0], str) else None
