"""A type checker takes the package and what stubs write, and finds what a change of the program breaks.

usage: stub_types.py PROGRAM
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import taken_names

MYPY = shutil.which("mypy")
if not MYPY:
    print("skipped: mypy is not installed (apt-get install mypy)")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
MISSION = """
(defsv place :states (Dock Floor) :init Floor :transitions :all)
(defevent pushed_away :effects (place Floor))
(defskill drive :input ($where place $speed float) :action (drive $where $speed)
  :interrupt () :success arrived :failure lost)
(defskill mission :success done :body ((drive where Dock speed 1) (success done)))
"""


class Types(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.path = pathlib.Path(self.directory.name)
        self.program = self.path / "mission.proskill"
        self.program.write_text(MISSION, encoding="utf-8")

    def stubs(self, program, name="robot"):
        subprocess.run([PROGRAM, "stubs", program, self.path / name], check=True, capture_output=True)
        return self.path / name

    def errors(self, *files, cwd=None):
        done = subprocess.run([MYPY, "--strict", "--no-error-summary", "--ignore-missing-imports",
                               f"--cache-dir={self.path / 'cache'}", *files], cwd=cwd or self.path,
                              env=dict(os.environ, MYPYPATH=str(ROOT / "python")), capture_output=True, text=True)
        return done.stdout + done.stderr

    def test_the_package_is_typed(self):
        self.assertEqual(self.errors("-p", "proskill"), "")

    def test_stubs_have_no_type_errors(self):
        self.assertEqual(self.errors("robot.py", cwd=self.stubs(self.program)), "")
        self.assertEqual(self.errors("robot.py", cwd=self.stubs(ROOT / "examples/rover/rover.proskill", "rover")), "")

    def test_names_of_the_generated_text_have_no_type_errors(self):
        self.program.write_text(taken_names.MISSION, encoding="utf-8")
        self.assertEqual(self.errors("robot.py", cwd=self.stubs(self.program)), "")

    def test_changes_of_the_program_are_type_errors(self):
        robot = self.stubs(self.program) / "robot.py"
        robot.write_text(robot.read_text(encoding="utf-8").replace("raise NotImplementedError",
                                                                   "return DriveResult.ARRIVED"), encoding="utf-8")
        self.assertEqual(self.errors("robot.py", cwd=robot.parent), "")
        for old, new, error in (
                ("$speed float", "$speed string", "incompatible with supertype"),
                (":action (drive $where $speed)", ":action (drive $where)", "incompatible with supertype"),
                (":success arrived", ":success came", 'has no attribute "ARRIVED"'),
                ("(defskill drive", "(defskill sing :action (sing))\n(defskill drive", "Cannot instantiate abstract class"),
                ("(defskill drive", "(defskill drive_on", "has no attribute"),
        ):
            with self.subTest(new):
                text = MISSION.replace(old, new).replace("speed 1)", 'speed "fast")' if "string" in new else "speed 1)")
                self.program.write_text(text.replace("((drive ", "((drive_on ") if "drive_on" in new else text,
                                        encoding="utf-8")
                self.stubs(self.program)
                self.assertIn(error, self.errors("robot.py", cwd=robot.parent))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
