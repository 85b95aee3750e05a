"""`proskill plan`: writes a mission by a planner, and verifies it."""

import argparse
import os
import subprocess
import sys

if __package__ in (None, ""):  # started by its path, without being installed
    sys.path[0] = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, os.pardir)

from proskill.planning.anml import anml_of  # noqa: E402
from proskill.planning.loop import Loop, Settings, say  # noqa: E402
from proskill.planning.pddl import Refused  # noqa: E402
from proskill.planning.planner import PLANNERS, require_planners  # noqa: E402


def settings_of(arguments: argparse.Namespace) -> Settings:
    planners = [arguments.planner] if arguments.planner else list(PLANNERS)
    return Settings(arguments.proskill, arguments.file, arguments.goal, planners, arguments.outcomes,
                    arguments.time_limit, arguments.memory_limit, arguments.name)


def main() -> int:
    parser = argparse.ArgumentParser(prog="proskill plan")
    parser.add_argument("--proskill", default="proskill")
    parser.add_argument("--planner")
    parser.add_argument("--outcomes", choices=("best", "all"), default="best")
    parser.add_argument("--time-limit", type=float, default=60)
    parser.add_argument("--memory-limit", type=int, default=4096)
    parser.add_argument("--name", default="plan")
    parser.add_argument("--output", default="")
    parser.add_argument("--anml", action="store_true")
    parser.add_argument("goal")
    parser.add_argument("file")
    arguments = parser.parse_args()
    try:
        loop = Loop(settings_of(arguments))
        if arguments.anml:
            require_planners()
            put(arguments, anml_of(loop.domain.text, loop.problem))
        else:
            put(arguments, program_of(arguments, loop.run()))
    except Refused as refused:
        if str(refused):
            say(f"error: {refused}")
        return refused.exit_code
    return 0


def program_of(arguments: argparse.Namespace, skill: str) -> str:
    """The program with the plan: it includes the file, as seen from the output."""
    folder = os.path.dirname(os.path.abspath(arguments.output)) if arguments.output else os.getcwd()
    included = os.path.relpath(os.path.abspath(arguments.file), folder)
    text = f"; A plan for {arguments.goal}, by `proskill plan`.\n\n(include \"{included}\")\n\n{skill}"
    done = subprocess.run([arguments.proskill, "fmt", "-"], input=text, stdout=subprocess.PIPE, text=True, check=True)
    return done.stdout


def put(arguments: argparse.Namespace, text: str) -> None:
    if not arguments.output:
        print(text, end="")
        return
    with open(arguments.output, "w", encoding="utf-8") as file:
        file.write(text)


sys.exit(main())
