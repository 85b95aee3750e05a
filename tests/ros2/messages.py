"""Messages of ROS 2: their encoding, and where their fields are from.

usage: messages.py PROGRAM
"""

import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
from proskill.ros.adapter import Unfit  # noqa: E402
from proskill.ros2 import cdr, messages  # noqa: E402
from proskill.ros2.interfaces import Interfaces, field, set_field, type_of  # noqa: E402

DRIVE = {"robot/action/Drive": {"goal": {"name": "string", "to.x": "float64", "to.y": "float64", "fast": "bool",
                                         "via": "geometry_msgs/Point[<=3]", "code": "uint8[2]"},
                                "result": {"path": "robot/Step[]"}},
         "robot/msg/Step": {"height": "float32", "left": {"force": "int16"}}}


class Encoding(unittest.TestCase):
    def test_numbers_are_aligned_and_strings_end_with_zero(self):
        goal, _ = Interfaces(DRIVE, "").action("robot/action/Drive")
        message = messages.filled(goal, [{"path": "name", "value": "ab"}, {"path": "to.x", "argument": 0},
                                         {"path": "fast", "value": True}, {"path": "via[0].z", "value": 2},
                                         {"path": "code[1]", "value": 5}], [1])
        encoded = cdr.encode(goal, message)
        self.assertEqual(encoded.hex(" "), "00 01 00 00 "
                         "03 00 00 00 61 62 00 00 "  # its length, "ab", the zero, one byte of alignment
                         "00 00 00 00 00 00 f0 3f 00 00 00 00 00 00 00 00 "  # to
                         "01 00 00 00 01 00 00 00 "  # fast, and the length of via
                         "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 40 "  # via[0]
                         "00 05")
        self.assertEqual(cdr.decode(goal, encoded), message)

    def test_the_other_order_of_bytes_is_read(self):
        of = Interfaces({"a/msg/B": {"x": "int32", "y": "float64"}}, "").message("a/msg/B")
        self.assertEqual(cdr.decode(of, bytes.fromhex("00000000 00000102 00000000 3ff0000000000000")), {"x": 258, "y": 1.0})

    def test_what_is_not_a_message_of_the_type_is_garbled(self):
        of = Interfaces({"a/msg/B": {"s": "string", "x": "int32[]"}}, "").message("a/msg/B")
        whole = cdr.encode(of, {"s": "hello", "x": [1, 2]})
        for size in range(len(whole)):
            with self.assertRaises(cdr.Garbled, msg=size):
                cdr.decode(of, whole[:size])
        with self.assertRaises(cdr.Garbled):
            cdr.decode(of, bytes.fromhex("00010000 01000000 00 000000 ffffffff"))

    def test_an_empty_message_has_a_byte(self):
        request, response = Interfaces(prefixes="").service("std_srvs/srv/Trigger")
        self.assertEqual(cdr.encode(request, cdr.initial(request)), bytes.fromhex("00010000 00"))
        self.assertEqual(list(response.fields), ["success", "message"])


class Types(unittest.TestCase):
    def test_files_of_ros_2_are_read(self):
        with tempfile.TemporaryDirectory() as prefix:
            for name, text in (("share/a/action/Go.action", "# to where\nPoint to\nfloat64 speed 1.5 # m/s\n---\nint32 OK=0\n"
                                "int32 code\nstring<=20 text \"no\"\n---\nfloat32 left\n"),
                               ("share/a/msg/Point.msg", "uint8 X=1\nfloat64[3] at\nb/Point[] others\n"),
                               ("share/b/msg/Point.msg", "bool is_far true\n")):
                file = pathlib.Path(prefix, name)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")
            goal, result = Interfaces(None, f"/nowhere:{prefix}").action("a/action/Go")
        self.assertEqual(cdr.initial(goal), {"to": {"at": [0.0, 0.0, 0.0], "others": []}, "speed": 1.5})
        self.assertEqual(cdr.initial(result), {"code": 0, "text": "no"})
        message = cdr.initial(goal)
        set_field(goal, message, "to.others[1].is_far", False)
        self.assertEqual(message["to"]["others"], [{"is_far": True}, {"is_far": False}])
        self.assertEqual(field(message, "to.at[2]"), 0.0)

    def test_what_is_not_a_type_is_reported(self):
        for given, why in (({"a/msg/B": {"x": "float"}}, "there is no type `float`"),
                           ({"a/msg/B": {"x": "Other"}}, "there is no type `a/msg/Other`"),
                           ({"a/msg/B": {"x": "B[]"}}, "the type `a/msg/B` contains itself"),
                           ({"a/msg/B": {"x": "int32[a]"}}, "there is no type `int32[a]`"),
                           ({"a/msg/B": {"p.x": "bool", "q": "bool", "p.y": "bool"}}, "must follow one another"),
                           ({"a/msg/C": {}}, "there is no type `a/msg/B`")):
            with self.subTest(why), self.assertRaises(Unfit) as caught:
                Interfaces(given, "").message("a/msg/B")
            self.assertIn(why, str(caught.exception))

    def test_fields_and_values_are_checked(self):
        goal, _ = Interfaces(DRIVE, "").action("robot/action/Drive")
        for path, value, why in (("to.z", 1, "no `z`; it has x, y"), ("code[2]", 1, "no `2`"), ("to", 1, "a message"),
                                 ("fast", 1, "of type bool cannot be 1"), ("to.x", True, "float64 cannot be True"),
                                 ("code[0]", 256, "uint8 cannot be 256"), ("name", 3, "string cannot be 3"),
                                 ("via", 3, "a message[] cannot be 3")):
            with self.subTest(path), self.assertRaises(Unfit) as caught:
                messages.check(goal, [{"path": path, "value": value}])
            self.assertIn(why, str(caught.exception))
        messages.check(goal, [{"path": "to.x", "value": 1}, {"path": "via[2].x", "argument": 0, "type": "float"}])
        self.assertEqual(messages.name_of(type_of(goal, "via")), "a message[]")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
