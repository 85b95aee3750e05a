"""Platforms in Python under `proskill run`, and the effects of their failures.

usage: runs.py PROGRAM
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
DRONE = ROOT / "examples/drone"
MISSION = """
(defskill fly :input ($how string) :action (fly $how) :interrupt () :success there)
(defskill mission :success done :failure failed
  :body ((fly how "HOW") (if (= fly.status success) (success done)) (failure failed)))
"""
ROBOT = """
import os, sys
sys.path.insert(0, PACKAGE)
from proskill import Platform, Stop
robot = Platform()

@robot.action
def fly(how: str, stop: Stop):
    print("flying", how)
    if how == "throw":
        raise ValueError("no wings")
    if how == "exit":
        os._exit(3)
    if how == "unknown":
        return "nowhere"
    if how == "interrupted":
        robot.interrupt("fly")
        stop.wait()
    return "there"

robot.run()
import time
time.sleep(LINGERS)
"""
# In seconds, after the end of the run.
LINGERS = {"lingers": 0.5, "stays": 40}


def run(program, platform, *options):
    done = subprocess.run([PROGRAM, "run", "--format", "json", "--until", "3600", *options, "--platform",
                           platform, program], capture_output=True, text=True)
    return done, [json.loads(line) for line in done.stdout.splitlines()]


class Runs(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.path = pathlib.Path(self.directory.name)

    def fly(self, how, *options):
        (self.path / "mission.proskill").write_text(MISSION.replace("HOW", how), encoding="utf-8")
        (self.path / "robot.py").write_text(f"PACKAGE = {str(ROOT / 'python')!r}\nLINGERS = {LINGERS.get(how, 0)}\n{ROBOT}", encoding="utf-8")
        platform = self.path / "platform.json"
        platform.write_text(json.dumps({"kind": "process", "command": [sys.executable, "robot.py"]}),
                            encoding="utf-8")
        recording = self.path / "run.json"
        done, lines = run(self.path / "mission.proskill", platform, "--record", recording, *options)
        self.recorded = json.loads(recording.read_text(encoding="utf-8"))["steps"]
        return done, lines[-1], [line["description"].removeprefix("fault: ") for line in lines if line.get("remark") == "fault"]

    def test_a_function_performs_an_action(self):
        done, end, faults = self.fly("well")
        self.assertEqual((done.returncode, end["mission"], faults), (0, "success", []))
        self.assertIn("flying well", done.stderr)

    def test_a_program_has_real_time_to_end_however_fast_the_clock_is(self):
        done, end, faults = self.fly("lingers", "--clock", "100x")
        self.assertEqual((done.returncode, end["mission"], faults), (0, "success", []))

    def test_a_program_that_stays_is_killed_after_real_time_however_slow_the_clock_is(self):
        begin = time.monotonic()
        done, end, faults = self.fly("stays", "--clock", "0.1x")
        self.assertLess(time.monotonic() - begin, 30)
        self.assertEqual((end["mission"], len(faults)), ("success", 1))

    def test_a_token_tells_of_the_interrupt(self):
        done, end, faults = self.fly("interrupted")
        self.assertEqual((end["mission"], faults), ("failure", []))
        self.assertIn("is interrupted from outside", [step["description"] for step in self.recorded])

    def test_faults_end_the_skill_and_stand_in_the_recording(self):
        for how, why in {"throw": "its action failed: ValueError: no wings",
                         "unknown": "its action has no result `nowhere`",
                         "exit": "the connection to the platform's program is lost: it ended with exit code 3"}.items():
            with self.subTest(how):
                done, end, faults = self.fly(how)
                self.assertEqual((done.returncode, end["mission"], faults[0]), (1, "failure", why))
                self.assertIn(("fault", f"fault: {why}"), [(step.get("remark"), step["description"]) for step in self.recorded])

    def test_the_drone_flies(self):
        done, lines = run(DRONE / "drone.proskill", DRONE / "robot/platform.json", "--clock", "50x")
        said = [(line.get("actor"), line["description"]) for line in lines if "description" in line]
        self.assertEqual(lines[-1]["why"], "the mission has ended", done.stderr)
        self.assertEqual(lines[-1]["mission"], "success", done.stderr)
        self.assertIn(("landing", "succeeds with `landed`"), said)
        self.assertIn(("camera_survey", "asks its action to stop"), said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
