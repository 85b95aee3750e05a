"""Stubs in Python: they run at once, keep what a user wrote, and show what has changed.

usage: stubs.py PROGRAM
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import taken_names

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
SURROUNDINGS = dict(os.environ, PYTHONPATH=str(ROOT / "python"))
MISSION = """
(defsv place :states (Dock Floor) :init Floor :transitions :all)
(defsv parcels :min 0 :max 3 :init 0)
(defevent pushed_away :effects (place Floor))
(defskill drive :input ($where place $speed float $class int $count nat $gently bool $name string)
  :action (drive $where $speed $class $count $gently $name "text" -3 2.5 true $speed)
  :interrupt ()
  :success arrived
  :failure (blocked lost))
(defskill rest :action (rest))
(defskill mission :success done :failure failed :body (
  (drive where Dock speed 1 class -2 count 3 gently false name "a")
  (rest)
  (if (= drive.status success) (success done)) (failure failed)))
"""
DRIVE = """
    def drive(self, where: Place, speed: float, class_: int, count: int, gently: bool, name_: str,
              argument7: str, argument8: int, argument9: float, argument10: bool, speed_: float,
              stop: Stop) -> DriveResult:
        assert where is Place.DOCK and isinstance(speed, (int, float)), where
        assert (class_, count, gently, name_, argument7) == (-2, 3, False, "a", "text")
        self.report(Event.PUSHED_AWAY)
        return DriveResult.ARRIVED

    def rest(self, stop: Stop) -> RestResult:
        return RestResult.SUCCESS
"""


class Stubs(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.path = pathlib.Path(self.directory.name)
        self.robot = self.path / "new" / "robot"
        self.program = self.path / "mission.proskill"
        self.program.write_text(MISSION, encoding="utf-8")

    def stubs(self, program=None, code=0):
        done = subprocess.run([PROGRAM, "stubs", program or self.program, self.robot],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def python(self, *words):
        return subprocess.run([sys.executable, "-B", "-W", "error", *words], cwd=self.robot, env=SURROUNDINGS,
                              capture_output=True, text=True)

    def fill_in(self, methods=DRIVE):
        text = (self.robot / "robot.py").read_text(encoding="utf-8")
        begin, end = text.index("    def drive"), text.index("\n\nif __name__")
        text = text[:begin] + methods.lstrip("\n") + text[end:]
        (self.robot / "robot.py").write_text(text.replace("Actions,\n", "Actions,\n    Event,\n"), encoding="utf-8")

    def change(self, old, new):
        text = self.program.read_text(encoding="utf-8")
        self.assertIn(old, text)
        self.program.write_text(text.replace(old, new), encoding="utf-8")

    def run_it(self):
        done = subprocess.run([PROGRAM, "run", "--until", "60", "--format", "json", "--platform",
                               self.robot / "platform.json", self.program],
                              capture_output=True, text=True, env=SURROUNDINGS)
        return [json.loads(line) for line in done.stdout.splitlines()], done

    def test_the_stubs_of_every_example_can_be_used_at_once(self):
        programs = [path for path in sorted(ROOT.glob("examples/*/*.proskill"))
                    if subprocess.run([PROGRAM, "check", path], capture_output=True).returncode == 0]
        self.assertGreaterEqual(len(programs), 5)
        for number, program in enumerate(programs):
            with self.subTest(program.name):
                self.robot = self.path / str(number)
                self.stubs(program)
                done = self.python("-c", "import robot; robot.platform_of(robot.Robot())")
                self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_what_is_not_filled_in_fails_when_it_is_called(self):
        self.stubs()
        lines, done = self.run_it()
        self.assertIn("fault: its action failed: NotImplementedError: ", [line.get("description") for line in lines])

    def test_arguments_and_results_have_the_types_of_the_program(self):
        self.stubs()
        self.fill_in()
        lines, done = self.run_it()
        self.assertEqual(lines[-1]["mission"], "success", done.stderr)
        self.assertIn(("pushed_away", "occurs"), [(line.get("actor"), line.get("description")) for line in lines])

    def test_a_skill_may_have_a_name_that_means_something_in_python(self):
        self.program.write_text("(defskill __init__ :action (x)) (defskill __f :action (x)) (defskill report :action (x))"
                                "(defskill mission :body ((__init__) (__f) (report)))", encoding="utf-8")
        self.stubs()
        lines, done = self.run_it()
        said = [line.get("description") for line in lines]
        self.assertEqual(said.count("fault: its action failed: NotImplementedError: "), 3, f"{said}\n{done.stderr}")

    def test_names_of_the_generated_text_itself(self):
        self.program.write_text(taken_names.MISSION, encoding="utf-8")
        self.stubs()
        done = self.python("-c", "import actions, robot\nassert issubclass(robot.Robot, actions.Actions)")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines, done = self.run_it()
        said = [line.get("description") for line in lines]
        self.assertEqual(said.count("fault: its action failed: NotImplementedError: "), taken_names.ACTIONS,
                         f"{said}\n{done.stderr}")

    def test_a_result_may_have_a_name_that_enumerations_reserve(self):
        self.change("(blocked lost)", "(_x_ x __init__ _ __2)")
        self.stubs()
        done = self.python("-c", "import actions; print(*(f'{it.name}={it.value}' for it in actions.DriveResult))")
        self.assertEqual(done.stdout.split(), ["ARRIVED=arrived", "X_=_x_", "X=x", "INIT__=__init__", "VALUE_=_",
                                               "VALUE_2=__2"], done.stderr)

    def test_what_a_user_wrote_is_kept(self):
        self.stubs()
        self.fill_in()
        (self.robot / "platform.json").write_text("{}", encoding="utf-8")
        mine = (self.robot / "robot.py").read_text(encoding="utf-8")
        said = self.stubs().stdout
        self.assertEqual((self.robot / "robot.py").read_text(encoding="utf-8"), mine)
        self.assertEqual((self.robot / "platform.json").read_text(encoding="utf-8"), "{}")
        self.assertEqual([line.split()[0] for line in said.splitlines()], ["written:", "kept:", "kept:"])

    def test_changes_in_a_generated_file_are_not_lost(self):
        self.stubs()
        actions = self.robot / "actions.py"
        whole = actions.read_text(encoding="utf-8")
        for text in (whole + "# mine\n", whole.replace("DOCK", "DOCKS"), "mine\n", ""):
            actions.write_text(text, encoding="utf-8")
            (self.robot / "robot.py").unlink(missing_ok=True)
            said = self.stubs(code=2)
            self.assertIn("is not as it was generated", said.stderr)
            self.assertEqual(actions.read_text(encoding="utf-8"), text)
            self.assertFalse((self.robot / "robot.py").exists())

    def test_a_new_skill_keeps_the_robot_from_starting_until_it_has_a_function(self):
        self.stubs()
        self.fill_in()
        self.change("(defskill rest", "(defskill sing :action (sing))\n(defskill rest")
        self.stubs()
        said = self.python("robot.py").stderr
        self.assertIn("TypeError: Can't instantiate abstract class Robot with abstract method", said)
        self.assertIn("sing", said)

    def test_a_result_that_is_gone_is_an_error_where_it_is_used(self):
        self.stubs()
        self.fill_in()
        self.change(":success arrived", ":success came")
        self.stubs()
        lines, _ = self.run_it()
        self.assertTrue([line for line in lines if "AttributeError: " in line.get("description", "")
                         and "ARRIVED" in line["description"]])

    def test_a_directory_that_cannot_be_made_is_an_error(self):
        self.robot = self.program / "robot"
        self.assertIn("cannot create", self.stubs(code=2).stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
