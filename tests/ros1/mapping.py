"""The file of a platform `ros1` is checked against the program and by its schema, without ROS.

usage: mapping.py PROGRAM
"""

import copy
import pathlib
import sys
import unittest

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1] / "ros"))
from platform_files import SCHEMA, Files, changed  # noqa: E402

MISSION = """
(defsv battery :states (Unknown Good Critical) :init Unknown)
(defsv lamp :states (On Off) :init Off)
(defsv count :init 0 :min 0 :max 3)
(defevent good :effects (battery Good))
(defevent critical :effects (battery Critical))
(defevent hit :effects ((battery Unknown) (lamp Off)))
(defskill fly :input ($x float) :action (fly $x 3) :success there :failure (lost blocked))
(defskill arm :action (arm))
(defskill mission :success done :body ((fly x 1) (arm) (if (= count 1) (set (count 0))) (success done)))
"""
GOOD = {
    "kind": "ros1", "python": "false", "node": "robot_1", "patience": 2, "startup": 5, "restarts": 1, "$schema": "x",
    "actions": {
        "fly": {"action": "/fly", "type": "my_msgs/FlyAction", "goal": {"pose.x": "$x", "frame": "map", "fast": True},
                "results": {"aborted": [{"field": "code", "above": 2, "result": "lost"}, {"result": "blocked"}], "rejected": "lost"}},
        "arm": {"service": "/arm", "type": "std_srvs/Trigger", "results": "success"},
    },
    "variables": {"battery": {"topic": "/battery", "type": "std_msgs/Float32", "field": "data", "hysteresis": 0.1,
                              "values": [{"value": "Critical", "below": 0.2}, {"value": "Good"}]}},
    "events": {"hit": {"topic": "/bumper", "type": "std_msgs/Bool", "field": "data", "equals": True}},
}
# A path, its value (None: removed), the error, and whether the schema knows it as well.
BAD = [
    ("kind2", 1, "there is no member `kind2`", True),
    ("node", "a b", "`node` must be a name", True),
    ("actions/arm", None, "mission.proskill:9:11: error: the platform file has no action for `arm`", False),
    ("actions/fli", {"topic": "/x", "type": "a/B"}, "there is no basic skill `fli`; did you mean `fly`?", False),
    ("actions/fly", {"type": "a/B"}, "`action`, `service` or `topic` is missing", True),
    ("actions/fly/type", "FlyAction", "must have the form package/Type", True),
    ("actions/fly/type", None, "`type` is missing", True),
    ("actions/fly/goal", {"x": "$y"}, "there is no argument of the action of `fly` `$y`; did you mean `$x`?", False),
    ("actions/fly/goal", {"x": [1]}, "must be a number, a string, true or false", True),
    ("actions/fly/results/aborted", "los", "there is no result of `fly` `los`; did you mean `lost`?", False),
    ("actions/fly/results/abort", "lost", "there is no terminal state `abort`", True),
    ("actions/fly/results/aborted", [], "must not be empty", True),
    ("actions/fly/results/aborted", [{"above": 2, "result": "lost"}], "`field` is missing", True),
    ("actions/fly/results/aborted", [{"field": "x", "result": "lost"}], "a `field` without", True),
    ("actions/arm/results", None, "`results` is missing", True),
    ("variables/batery", {}, "there is no state variable `batery`; did you mean `battery`?", True),
    ("variables/count", copy.deepcopy(GOOD["variables"]["battery"]), "`count` is a number", False),
    ("variables/battery/values", [], "must not be empty", True),
    ("variables/battery/values", [{"value": "Full"}], "there is no value of `battery` `Full`", False),
    ("variables/battery/values", [{"value": "Unknown"}], "no event sets `battery` to `Unknown`: add (defevent", False),
    ("variables/battery/values", [{"value": "Good"}, {"value": "Critical"}], "are never reached", False),
    ("variables/battery/values", [{"value": "Good", "below": "x"}], "`below` must be a number", True),
    ("variables/battery/hysteresis", -1, "`hysteresis` must be a number that is not negative", True),
    ("variables/battery/timeout", 1, "`timeout` and `silent` belong together", True),
    ("events/hit/equals", None, "`below`, `above` or `equals` is missing", True),
    ("events/bump", copy.deepcopy(GOOD["events"]["hit"]), "there is no event `bump`", False),
    ("restarts", -1, "`restarts` must be a natural number", True),
]


class Mapping(Files):
    mission = MISSION

    def test_a_right_file_reaches_the_adapter(self):
        """Which is the program `false` here."""
        self.assertIn("the connection to the ROS adapter is lost: it ended with exit code 1", self.errors(GOOD))
        SCHEMA.validate(GOOD)

    def test_each_error_is_named(self):
        for path, value, error, is_in_schema in BAD:
            with self.subTest(f"{path} {value}"):
                self.has(error, changed(GOOD, path.split("/"), value), is_in_schema)

    def test_the_example_fits_the_schema(self):
        self.example_fits("ros1")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
