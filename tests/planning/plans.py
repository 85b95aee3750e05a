"""`proskill plan` with real planners: an optimistic plan is found wrong and corrected.

usage: plans.py PROGRAM

PROSKILL_PYTHON names a Python with unified-planning, up-aries and up-tamer.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
PYTHON = os.environ.get("PROSKILL_PYTHON", sys.executable)
SURVEY = ROOT / "docs/bridges/survey.proskill"
GOAL = "(and (area Photographed) (flight OnGround))"

FOUND = subprocess.run([PYTHON, "-c", "import unified_planning, up_aries, up_tamer"], capture_output=True, check=False)
if FOUND.returncode != 0:
    print("skipped: unified-planning is not installed (pip install unified-planning up-aries up-tamer)")
    sys.exit(77)


def plan(goal, file, *options):
    command = [PROGRAM, "plan", "--python", PYTHON, *options, goal, str(file)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def changed(text, folder):
    path = pathlib.Path(folder) / "changed.proskill"
    path.write_text(text, encoding="utf-8")
    return path


class Plans(unittest.TestCase):
    def test_the_drone_does_not_land_while_it_photographs(self):
        for planner in ("aries", "tamer"):
            with self.subTest(planner), tempfile.TemporaryDirectory() as folder:
                out = pathlib.Path(folder) / "mission.proskill"
                done = plan(GOAL, SURVEY, "--planner", planner, "-o", str(out))
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("its order: gps_fixed, take_off, (photograph | land)", done.stderr)
                self.assertIn("not verified: `photograph` can end because its invariant `in_air` fails", done.stderr)
                self.assertIn("constraint 1: `land` and `photograph` must not run at the same time", done.stderr)
                self.assertIn("its order: gps_fixed, take_off, photograph, land", done.stderr)
                self.assertIn("verified: every run", done.stderr)
                for command in (["check", out], ["fmt", "--check", out]):
                    checked = subprocess.run([PROGRAM, *command], capture_output=True, text=True, check=False)
                    self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)

    def test_where_to_go(self):
        """The planner chooses the values of inputs that effects read."""
        with tempfile.TemporaryDirectory() as folder:
            text = """(defsv place :states (Dock Bed Well) :init Dock)
(defsv water :states (None Some) :init None)
(defsv bed :states (Dry Wet) :init Dry)
(defskill go :input ($to place) :time_interval [2,8] :action (go $to) :success there (:effects (place $to)))
(defskill draw :precondition (there (place Well)) :time_interval [1,2] :action (d) :success done (:effects (water Some)))
(defskill pour :precondition (there (and (place Bed) (water Some))) :invariant (there (:guard (place Bed)))
  :time_interval [1,2] :action (p) :success done (:effects (bed Wet)))
"""
            done = plan("(and (bed Wet) (place Dock))", changed(text, folder), "--planner", "aries")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("constraint 1: `go` and `pour` must not run at the same time", done.stderr)
            self.assertRegex(done.stderr, "its order: go Well, .*, pour, go Dock\n  verified: every run")
            self.assertIn("(go to Well)", done.stdout)

    def test_numbers_and_resources(self):
        """Aries counts within bounds, and a constraint concerns the skill that the verifier blames."""
        with tempfile.TemporaryDirectory() as folder:
            text = """(defresource arm)
(defsv depth :init 0 :min 0 :max 3)
(defsv slot :states (A B) :init A)
(defsv sample :states (None Kept) :init None)
(defskill cut :precondition (room (< depth 3)) :resources (arm) :time_interval [2,8] :action (cut)
  :success deeper (:effects (depth (+ depth 1)) :postcondition (> depth 0)))
(defskill turn :input ($to slot) :precondition (other (/= slot $to)) :time_interval [1,4] :action (turn $to)
  :success there (:effects (slot $to) :postcondition (slot $to)))
(defskill take :precondition (deep (>= depth 2) turned (slot B)) :resources (arm) :time_interval [1,3] :action (take)
  :success taken (:effects (sample Kept)))
"""
            done = plan("(sample Kept)", changed(text, folder), "--planner", "aries")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, "(?m)^  verified: every run")
            self.assertEqual(done.stdout.count("(cut)"), 2, done.stdout)
            self.assertEqual(done.stdout.count("(turn to"), 1, done.stdout)

    def test_moves_that_are_allowed(self):
        """A lift does not skip a floor, and a move waits for the end of the one before."""
        with tempfile.TemporaryDirectory() as folder:
            text = """(defsv floor :states (Ground First Second) :init Ground :transitions ((Ground First) (First Second)))
(defskill ride :input ($to floor) :time_interval [5,20] :action (ride $to) :success there (:effects (floor $to)))
(defskill climb :time_interval [2,3] :action (climb) :success done (:effects (floor Second)))
"""
            done = plan("(floor Second)", changed(text, folder), "--planner", "aries")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, "^plan 1, .*\n  its order: ride First, .*\n  verified: every run")

    def test_a_skill_that_may_take_any_time(self):
        with tempfile.TemporaryDirectory() as folder:
            text = """(defsv gate :states (Shut Open) :init Shut)
(defsv cart :states (Out In) :init Out)
(defskill open_gate :time_interval [0.5,2] :action (open) :success open (:effects (gate Open)))
(defskill enter :precondition (way (gate Open)) :action (enter) :success there (:effects (cart In)))
"""
            for planner in ("aries", "tamer"):
                done = plan("(cart In)", changed(text, folder), "--planner", planner)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertRegex(done.stderr, "its order: open_gate, enter\n  verified: every run")
            done = plan("(cart In)", changed(text, folder), "--anml")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("action enter", done.stdout)

    def test_an_impossible_goal(self):
        with tempfile.TemporaryDirectory() as folder:
            text = SURVEY.read_text(encoding="utf-8").replace("(area Photographed)", "(area Unknown)")
            done = plan(GOAL, changed(text, folder))
            self.assertEqual(done.returncode, 1)
            self.assertIn("error: the goal is impossible: no order of basic skills and events reaches it", done.stderr)
            self.assertEqual(done.stdout, "")

    def test_what_no_order_repairs(self):
        """The world takes the area away again: no order of skills helps, and the verifier proves it by times."""
        with tempfile.TemporaryDirectory() as folder:
            text = SURVEY.read_text(encoding="utf-8")
            text += "(defevent clouds :every [1,%d] :effects (flight OnGround))\n"
            done = plan(GOAL, changed(text % 9, folder), "--planner", "aries")
            self.assertEqual(done.returncode, 1)
            self.assertIn("the goal is impossible", done.stderr)
            done = plan(GOAL, changed(text % 30, folder), "--planner", "aries")
            self.assertEqual(done.returncode, 3)
            self.assertIn("not verified", done.stderr)

    def test_the_problem_in_anml_is_read_again(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "survey.anml"
            done = plan(GOAL, SURVEY, "--anml", "-o", str(out))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("( start, end ) flight_is_inair;", out.read_text(encoding="utf-8"))
            read = ("from unified_planning.io import ANMLReader\nimport sys\n"
                    "problem = ANMLReader().parse_problem(sys.argv[1])\nprint(len(problem.actions), len(problem.goals))")
            again = subprocess.run([PYTHON, "-c", read, str(out)], capture_output=True, text=True, check=False)
            self.assertEqual(again.stdout.split(), ["4", "1"], again.stderr)

    def test_inputs_that_nothing_reads(self):
        """They become inputs of the plan, and a mission calls it with a value for each."""
        text = """(defsv place :states (Dock Bed) :init Dock)
(defsv bed :states (Dry Wet) :init Dry)
(defsv drops :init 1 :min 0 :max 9)
(defskill go :input ($to place $speed float $why string) :action (go $to $speed) :success there (:effects (place $to)))
(defskill pour :input ($much int $slow bool $from place $n drops) :precondition (there (place Bed))
  :action (pour $much) :success done (:effects (bed Wet)))
"""
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "mission.proskill"
            done = plan("(bed Wet)", changed(text, folder), "--planner", "aries", "-o", str(out))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("(plan go_speed 0 go_why \"go_why\" pour_much 0 pour_slow true pour_from Dock pour_n 0)",
                          " ".join(out.read_text(encoding="utf-8").split()))
            for command in (["check", out], ["fmt", "--check", out], ["verify", out]):
                checked = subprocess.run([PROGRAM, *command], capture_output=True, text=True, check=False)
                self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
            done = plan("(and (bed Wet) (bed Dry))", changed(text, folder))
            self.assertEqual(done.returncode, 1, done.stderr)

    def test_planners_that_know_no_times(self):
        """They get skills in one step: what a start takes and the end gives back does not change, and an invariant that
        the start makes true is not required before it."""
        text = """(defresource arm)
(defsv n :init 0 :min 0 :max 5)
(defsv lid :states (Shut Open) :init Shut)
(defskill fill :precondition (few (< n 3)) :resources (arm) :start (lid Open) :invariant (open (:guard (lid Open)))
  :time_interval [1,2] :action (f) :success done (:effects ((n (+ n 1)) (lid Shut))))
"""
        read = """import sys
sys.path.insert(0, sys.argv[1])
from unified_planning.io import PDDLReader
from proskill.planning.classical import without_times
from proskill.planning.planner import limited
domain, problem = open(sys.argv[2]).read(), sys.argv[3]
read = PDDLReader().parse_problem_string(limited(domain), open(problem).read())
without_times(read)
for action in read.actions:
    print(action.preconditions, [str(each) for each in action.effects])"""
        with tempfile.TemporaryDirectory() as folder:
            path = changed(text, folder)
            for name, words in (("domain", []), ("problem", ["--goal", "(= n 2)"])):
                out = subprocess.run([PROGRAM, "emit", "pddl", *words, str(path)], capture_output=True, check=True).stdout
                (pathlib.Path(folder) / name).write_bytes(out)
            command = [PYTHON, "-c", read, str(ROOT / "python"), f"{folder}/domain", f"{folder}/problem"]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr, "")
        self.assertNotIn("lid", done.stdout.split("[", 2)[1], done.stdout)
        self.assertIn("fill-is-idle", done.stdout)
        self.assertNotIn("'arm-left", done.stdout)
        self.assertNotIn("'fill-is-idle :=", done.stdout.replace("fill-is-idle := true", ""))
        self.assertIn("n := (n + 1)", done.stdout)

    def test_a_planner_that_is_not_installed_is_named(self):
        for planner, package in (("enhsp", "up_enhsp"), ("fast-downward", "up_fast_downward")):
            found = subprocess.run([PYTHON, "-c", f"import {package}"], capture_output=True, check=False).returncode == 0
            done = plan(GOAL, SURVEY, "--planner", planner)
            with self.subTest(planner):
                if found:
                    self.assertIn("verified: every run", done.stderr)
                else:
                    self.assertIn(f"{planner}: not installed (pip install {package.replace('_', '-')})", done.stderr)

    def test_a_wrong_goal(self):
        done = plan("(area Painted)", SURVEY)
        self.assertEqual(done.returncode, 2)
        self.assertIn("`Painted` is not a value of `area`", done.stderr)

    def test_a_limit_of_time(self):
        done = plan(GOAL, SURVEY, "--planner", "aries", "--memory-limit", "64")
        self.assertEqual(done.returncode, 3)
        self.assertIn("no planner has found a plan", done.stderr)
        self.assertIn("verifier: there may be one", done.stderr)


unittest.main(argv=sys.argv[:1])
