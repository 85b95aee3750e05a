"""Logs of runs (`proskill run --record FILE.btlog`) against their steps.

usage: logs.py PROGRAM
"""

import collections
import decimal
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

import btlog

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
EXAMPLES = ["examples/drone/drone.proskill", "examples/arm/arm.proskill", "examples/rover/rover.proskill",
            "docs/tour/dock.proskill"]
# What a skill of these and the next calls has ended with, as a node's status.
ENDS = {"success": btlog.SUCCESS, "no_status": btlog.SKIPPED}
TWISTED = """
(defsv n :min 0 :max 3 :init 0)
(defskill fly :input ($how string) :precondition (few (< n 3)) :time_interval [2,5] :action (fly $how)
  :interrupt () :success there :failure lost)
(defskill try :success well :failure badly
  :body ((fly how "a") (if (= fly.status success) (success well)) (failure badly)))
(defskill mission :body (
  (while (< n 2) (try) (set (n (+ n 1))))
  (race ((try)) ((^ [1,6])))
  (// ((try)) ((^ 1) (fly.interrupt)))
  (set (n 3)) (try)
  (case (try) (success (^ 1)) (else (^ 2)))))
"""


def microseconds(step):
    return int(decimal.Decimal(step["date"]["exact"]) * 1_000_000)


def calls_of(steps):
    """The calls of a run: skill, start and end in microseconds, and the status that the call had."""
    status, since, ended = collections.defaultdict(lambda: "no_status"), {}, []
    for step in steps:
        for change in step["changes"]:
            if change["variable"].endswith(".status"):
                status[change["variable"].removesuffix(".status")] = change["after"]
        said = step["description"]
        if called := re.fullmatch(r"calls `(\w+)`", said):
            since[step["actor"], called[1]] = microseconds(step)
        elif left := re.match(r"(?:continues after|notices that) `(\w+)`", said):
            ends = ENDS.get(status[left[1]], btlog.FAILURE)
            ended.append((left[1], since.pop((step["actor"], left[1])), microseconds(step), ends))
    return collections.Counter(ended)


def calls_in(tree, changes, called):
    """The same according to a log. What stands for the program calls nothing."""
    roots = list(tree.trees[""].iter()) if tree.name == "program" else []
    since, ended = {}, []
    for time, uid, status in changes:
        node = tree.nodes[uid]
        if node in roots or node.tag not in called and node.tag != "SubTree":
            continue
        skill = node.get("ID") if node.tag == "SubTree" else node.tag
        if status == btlog.RUNNING:
            since[uid] = time
        elif uid in since:
            begun = since.pop(uid)
            if status != btlog.IDLE:
                ended.append((skill, begun, time, status))
    return collections.Counter(ended)


class Logs(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.path = pathlib.Path(directory.name)
        self.log = self.path / "run.btlog"

    def run_it(self, program, *options):
        done = subprocess.run([PROGRAM, "run", "--format", "json", "--record", self.log, *options, program],
                              capture_output=True, text=True, cwd=ROOT)
        self.assertNotEqual(done.returncode, 2, done.stderr)
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        return [line for line in lines if line["kind"] == "step"], btlog.read(self.log.read_bytes())

    def test_the_calls_of_a_log_are_those_of_its_run(self):
        twisted = self.path / "twisted.proskill"
        twisted.write_text(TWISTED, encoding="utf-8")
        seen = collections.Counter()
        for program in [twisted, *EXAMPLES]:
            for seed in range(8):
                with self.subTest(program=program, seed=seed):
                    steps, (tree, start, changes) = self.run_it(program, "--seed", str(seed), "--until", "2000")
                    self.assertEqual(start, 0)
                    expected = calls_of(steps)
                    self.assertEqual(calls_in(tree, changes, {skill for skill, *_ in expected}), expected)
                    self.assertGreater(len(expected), 0)
                    seen.update(status for (_, _, _, status) in expected)
        for status in (btlog.SUCCESS, btlog.FAILURE, btlog.SKIPPED):
            self.assertGreater(seen[status], 0)

    def test_uids_are_stable_and_times_grow(self):
        program = EXAMPLES[0]
        _, (first, _, changes) = self.run_it(program)
        _, (second, _, _) = self.run_it(program, "--seed", "3")
        self.assertEqual([it.attrib for it in first.nodes.values()], [it.attrib for it in second.nodes.values()])
        self.assertEqual(sorted(first.nodes), list(range(1, len(first.nodes) + 1)))
        times = [time for time, _, _ in changes]
        self.assertEqual(times, sorted(times))

    def test_the_root_has_the_result_of_the_mission(self):
        for seed in range(6):
            done = subprocess.run([PROGRAM, "run", "--seed", str(seed), "--record", self.log, EXAMPLES[3]],
                                  capture_output=True, text=True, cwd=ROOT)
            tree, _, changes = btlog.read(self.log.read_bytes())
            last = btlog.replay(tree, changes)
            succeeded = done.stdout.rstrip().endswith("recharge: success")
            self.assertEqual(last[1], btlog.SUCCESS if succeeded else btlog.FAILURE)
            self.assertNotIn(btlog.RUNNING, last.values())

    def test_a_log_in_real_time_begins_with_its_date_and_can_be_read_after_a_kill(self):
        process = subprocess.Popen([PROGRAM, "run", "--clock", "10x", "--format", "json", "--record", self.log, EXAMPLES[0]],
                                   stdout=subprocess.PIPE, text=True, cwd=ROOT)
        for _ in range(12):
            process.stdout.readline()
        process.send_signal(signal.SIGKILL)
        process.wait()
        process.stdout.close()
        _, start, _ = btlog.read(self.log.read_bytes())
        self.assertGreater(start, 1_600_000_000_000_000)

    def test_a_program_without_composite_skills_has_no_log(self):
        program = self.path / "library.proskill"
        program.write_text("(defskill fly :action (fly))", encoding="utf-8")
        self.log.write_text("as it was")
        done = subprocess.run([PROGRAM, "run", "--record", self.log, program], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("a .btlog file is not possible: no composite skill is executed", done.stderr)
        self.assertEqual(self.log.read_text(), "as it was")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
