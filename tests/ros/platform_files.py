"""Files of platforms are checked against a program and by their schema."""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    from jsonschema import Draft202012Validator as Validator
except ImportError:
    print("skipped: no python3-jsonschema")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
SCHEMA = Validator(json.loads((ROOT / "docs/platform.schema.json").read_text(encoding="utf-8")))


def changed(platform, path, value):
    """A copy with another value at the path; None removes it."""
    platform = copy.deepcopy(platform)
    *before, last = path
    place = platform
    for step in before:
        place = place[step]
    if value is None:
        del place[last]
    else:
        place[last] = value
    return platform


class Files(unittest.TestCase):
    """The classes have `mission`, a program."""

    def errors(self, platform):
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory)
            (path / "mission.proskill").write_text(self.mission, encoding="utf-8")
            (path / "platform.json").write_text(json.dumps(platform), encoding="utf-8")
            done = subprocess.run([PROGRAM, "run", "--platform", path / "platform.json", path / "mission.proskill"],
                                  capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        return done.stderr

    def has(self, error, platform, is_in_schema):
        self.assertIn(error, self.errors(platform))
        self.assertEqual(SCHEMA.is_valid(platform), not is_in_schema)

    def example_fits(self, name):
        SCHEMA.validate(json.loads((ROOT / "examples" / name / "platform.json").read_text(encoding="utf-8")))
