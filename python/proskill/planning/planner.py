"""Runs a planner of unified-planning in a process of its own, with limits of time and memory."""

from __future__ import annotations

import json
import math
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from fractions import Fraction
from typing import List, Optional

PLANNERS = {"aries": "up-aries", "tamer": "up-tamer", "enhsp": "up-enhsp", "fast-downward": "up-fast-downward"}

WITHOUT_TIMES = ("enhsp", "fast-downward")


@dataclass
class Planned:
    """An action of a plan. The planner chose its times; the platform will choose others."""

    action: str
    start: Fraction
    end: Fraction


@dataclass
class Answer:
    status: str  # solved, unsolvable, unknown
    plan: List[Planned]
    words: str = ""


DURATION = re.compile(r"\?duration ([\d.]+)")
UNLIMITED = re.compile(r":duration (\(>= \?duration [\d.]+\))")


def limited(domain: str) -> str:
    """Each duration with an upper limit, without which unified-planning reads none. Where there is no limit it is one
    that no plan needs, longer than all others together."""
    longest = 1000 + 10 * math.ceil(sum(Fraction(each) for each in DURATION.findall(domain)))
    return UNLIMITED.sub(rf":duration (and \1 (<= ?duration {longest}))", domain)


def run_planner(engine: str, domain: str, problem: str, seconds: float, megabytes: int) -> Answer:
    """Asks a planner in a unit of time in which all durations are whole: Aries fails with others."""
    domain = limited(domain)
    unit = Fraction(1, math.lcm(*(Fraction(each).denominator for each in DURATION.findall(domain))))
    scaled = DURATION.sub(lambda it: f"?duration {Fraction(it[1]) / unit}", domain)
    answer = answer_of(engine, scaled, problem, seconds, megabytes)
    answer.plan = [Planned(each.action, each.start * unit, each.end * unit) for each in answer.plan]
    return answer


def require_planners() -> None:
    """Raises Refused if none are installed.

    Nobody needs a planner to know that a goal is wrong or impossible, so this is asked last."""
    try:
        import unified_planning  # noqa: F401
    except ImportError as missing:
        from proskill.planning.pddl import Refused

        raise Refused("planners are not installed. In a virtual environment: pip install unified-planning up-aries "
                      "up-tamer;\nthen run this again in it, or with --python ENVIRONMENT/bin/python") from missing


def answer_of(engine: str, domain: str, problem: str, seconds: float, megabytes: int) -> Answer:
    require_planners()
    with tempfile.TemporaryDirectory(prefix="proskill-plan-") as folder:
        for name, text in (("domain.pddl", domain), ("problem.pddl", problem)):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        command = [sys.executable, os.path.abspath(__file__), engine, folder, str(seconds), str(megabytes)]
        child = subprocess.Popen(command, text=True, start_new_session=True, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE)
        try:
            out, err = child.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            return Answer("unknown", [], f"no plan within {seconds:g} s")
        finally:
            kill_all_of(child)
        return answer_in(out, err)


def kill_all_of(child: "subprocess.Popen[str]") -> None:
    """Ends the process with all that it has started."""
    try:
        os.killpg(child.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    child.wait()


def answer_in(out: str, err: str) -> Answer:
    lines = [line for line in out.splitlines() if line.startswith("{\"status\"")]
    if not lines:
        last = [line for line in err.strip().splitlines() if line][-1:]
        return Answer("unknown", [], last[0] if last else "the planner has ended without an answer")
    try:
        read = json.loads(lines[-1])
        plan = [Planned(each["action"], Fraction(each["start"]), Fraction(each["end"])) for each in read["plan"]]
        if read["status"] in ("solved", "unsolvable", "unknown"):
            return Answer(read["status"], plan, read["words"])
    except (ValueError, KeyError, TypeError, ArithmeticError):
        pass
    return Answer("unknown", [], "the planner's answer cannot be read")


# --- In the process of the planner


def main(engine: str, folder: str, seconds: str, megabytes: str) -> None:
    limit = int(megabytes) << 20
    resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    from unified_planning.engines import PlanGenerationResultStatus as Status
    from unified_planning.io import PDDLReader
    from unified_planning.shortcuts import OneshotPlanner, get_environment

    get_environment().credits_stream = None
    problem = PDDLReader().parse_problem(os.path.join(folder, "domain.pddl"), os.path.join(folder, "problem.pddl"))
    if engine == "aries":
        suit_aries(problem)
    if engine in WITHOUT_TIMES:
        sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, os.pardir))
        from proskill.planning.classical import without_times

        without_times(problem)
    log = os.path.join(folder, "log")
    with open(log, "w", encoding="utf-8") as output:  # without this, Aries leaves a file in /tmp
        try:
            with OneshotPlanner(name=engine) as planner:
                result = planner.solve(problem, timeout=float(seconds), output_stream=output)
        except Exception as error:  # pylint: disable=broad-exception-caught
            words = panic_in(log) or reason_of(error, engine, problem)
            return print(json.dumps({"status": "unknown", "plan": [], "words": words}))
    if not result.plan and result.status == Status.INTERNAL_ERROR and engine in WITHOUT_TIMES:
        words = lacking(engine, problem) or "internal error"
        return print(json.dumps({"status": "unknown", "plan": [], "words": words}))
    proved = (Status.UNSOLVABLE_PROVEN, Status.UNSOLVABLE_INCOMPLETELY)
    status = "solved" if result.plan else "unsolvable" if result.status in proved else "unknown"
    words = "" if result.plan else result.status.name.lower().replace("_", " ")
    print(json.dumps({"status": status, "plan": steps_of(result.plan), "words": words}))


def reason_of(error: Exception, engine: str, problem) -> str:  # type: ignore[no-untyped-def]
    from unified_planning.exceptions import UPNoRequestedEngineAvailableException as NotInstalled

    if isinstance(error, NotInstalled):
        return f"not installed (pip install {PLANNERS[engine]})"
    if engine in WITHOUT_TIMES and (words := lacking(engine, problem)):
        return words
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    return lines[0] if lines else type(error).__name__


def lacking(engine: str, problem) -> str:  # type: ignore[no-untyped-def]
    """What a problem has that a planner does not know."""
    from unified_planning.shortcuts import get_environment

    known = get_environment().factory.engine(engine).supported_kind().features
    missing = sorted(each.lower().replace("_", " ") for each in problem.kind.features - known)
    return f"it does not know {', '.join(missing)}" if missing else ""


def suit_aries(problem) -> None:  # type: ignore[no-untyped-def]
    """Aries counts in integers, as programs do, and reads them at moments only. So a condition about numbers over
    all of an action is one at its start and its end; the verifier says where that is not enough."""
    os.environ["ARIES_UP_ASSUME_REALS_ARE_INTS"] = "true"
    if all(each.type.is_bool_type() for each in problem.fluents):
        return
    os.environ["ARIES_LCP_SYMMETRY_BREAKING"] = "simple"  # its usual one fails where effects count
    variables = problem.environment.free_vars_extractor
    for action in problem.actions:
        conditions = dict(getattr(action, "conditions", {}))
        if not conditions:
            continue
        action.clear_conditions()
        for interval, all_of_it in conditions.items():
            for each in all_of_it:
                is_number = any(not it.fluent().type.is_bool_type() for it in variables.get(each))
                moments = {interval.lower, interval.upper} if is_number else {interval}
                for moment in sorted(moments, key=str):
                    action.add_condition(moment, each)


def panic_in(log: str) -> str:
    """Why a planner of Rust has ended."""
    with open(log, encoding="utf-8", errors="replace") as file:
        lines = file.read().splitlines()
    for line, following in zip(lines, lines[1:]):
        if " panicked at " in line:
            return f"internal error: {following}"
    return ""


def steps_of(plan: Optional[object]) -> List[dict]:  # type: ignore[type-arg]
    """A plan without times is one action after the other."""
    if plan is None:
        return []
    if hasattr(plan, "timed_actions"):
        return [{"action": each.action.name, "start": str(start), "end": str(start + (length or 0))}
                for start, each, length in plan.timed_actions]
    return [{"action": each.action.name, "start": str(i), "end": str(i + Fraction(1, 2))}
            for i, each in enumerate(plan.actions)]  # type: ignore[attr-defined]


if __name__ == "__main__":
    main(*sys.argv[1:])
