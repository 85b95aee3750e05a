"""The file of a platform `ros2` is checked against the program and by its schema, without DDS. What it shares with
`ros1` is tested in tests/ros1/mapping.py.

usage: mapping.py PROGRAM
"""

import pathlib
import sys
import unittest

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1] / "ros"))
from platform_files import SCHEMA, Files, changed  # noqa: E402

MISSION = """
(defsv battery :states (Unknown Good Critical) :init Unknown)
(defevent good :effects (battery Good))
(defevent critical :effects (battery Critical))
(defevent hit :effects (battery Unknown))
(defskill fly :input ($x float) :action (fly $x 3) :success there :failure (lost blocked))
(defskill arm :action (arm))
(defskill say :action (say))
(defskill mission :success done :body ((fly x 1) (arm) (say) (success done)))
"""
GOOD = {
    "kind": "ros2", "python": "false", "node": "robot_1", "namespace": "/fleet/one", "domain": 7, "patience": 2,
    "startup": 5, "restarts": 1, "$schema": "x",
    "types": {"my_msgs/action/Fly": {"goal": {"pose.x": "float64", "frame": {"name": "string"}}, "result": {"code": "int32"}}},
    "actions": {
        "fly": {"action": "/fly", "type": "my_msgs/action/Fly", "goal": {"pose.x": "$x", "frame.name": "map"},
                "results": {"aborted": [{"field": "code", "above": 2, "result": "lost"}, {"result": "blocked"}],
                            "rejected": "lost", "canceled": "lost"}},
        "arm": {"service": "arm", "type": "std_srvs/srv/Trigger", "results": "success"},
        "say": {"topic": "say", "type": "std_msgs/msg/Empty"},
    },
    "variables": {"battery": {"topic": "/battery", "type": "std_msgs/msg/Float32", "field": "data", "hysteresis": 0.1,
                              "values": [{"value": "Critical", "below": 0.2}, {"value": "Good"}]}},
    "events": {"hit": {"topic": "/bumper", "type": "std_msgs/msg/Bool", "field": "data", "equals": True}},
}
# A path, its value (None: removed), the error, and whether the schema knows it as well.
BAD = [
    ("kind2", 1, "there is no member `kind2`", True),
    ("node", "a b", "`node` must be a name", True),
    ("namespace", "a-b", "`namespace` must have names of letters", True),
    ("domain", 233, "`domain` must be a natural number up to 232", True),
    ("domain", 1.5, "`domain` must be a natural number up to 232", True),
    ("types", [], "`types` must be an object", True),
    ("types/my_msgs/action/Fly", "float64", "must be an object", True),
    ("actions/arm", None, "mission.proskill:7:11: error: the platform file has no action for `arm`", False),
    ("actions/fly/type", "my_msgs/Fly", "must have the form package/action/Type", True),
    ("actions/fly/type", "my_msgs/action/", "must have the form package/action/Type", True),
    ("actions/arm/type", "std_srvs/msg/Trigger", "must have the form package/srv/Type", True),
    ("actions/say/type", "std_msgs/Empty", "must have the form package/msg/Type", True),
    ("actions/fly/goal", {"x": "$y"}, "there is no argument of the action of `fly` `$y`; did you mean `$x`?", False),
    ("actions/fly/results/preempted", "lost", "there is no terminal state `preempted`", True),
    ("variables/battery/type", "std_msgs/Float32", "must have the form package/msg/Type", True),
    ("events/hit/type", "std_msgs/srv/Bool", "must have the form package/msg/Type", True),
    ("events/hit/equals", None, "`below`, `above` or `equals` is missing", True),
]


def steps_of(path):
    """Names of types have slashes of their own."""
    return ["types", path.removeprefix("types/")] if path.startswith("types/") else path.split("/")


class Mapping(Files):
    mission = MISSION

    def test_a_right_file_reaches_the_adapter(self):
        """Which is the program `false` here; without Fast DDS that is said instead."""
        self.assertRegex(self.errors(GOOD), "the connection to the ROS adapter is lost: it ended with exit code 1"
                                            "|platforms of kind `ros2` need Fast DDS")
        SCHEMA.validate(GOOD)

    def test_each_error_is_named(self):
        for path, value, error, is_in_schema in BAD:
            with self.subTest(f"{path} {value}"):
                self.has(error, changed(GOOD, steps_of(path), value), is_in_schema)

    def test_the_example_fits_the_schema(self):
        self.example_fits("ros2")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
