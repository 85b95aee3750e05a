"""Goals, services, topics and faults of a platform `ros2`, with an action server that misbehaves as its goals say.

usage: goals.py PROGRAM
"""

import os
import signal
import subprocess
import sys

import ros
import server_goals as how
from missions import FLY, OTHERS, STOP_AFTER, Missions
from runs import main, until

PLATFORM = {
    "kind": "ros2",
    "patience": 5,
    "startup": 30,
    "python": sys.executable,
    "types": {"test_msgs/action/Fly": {"goal": {"how": "int32"}, "result": {"code": "int32"}}},
    "actions": {
        "fly": {"action": "/fly", "type": "test_msgs/action/Fly", "goal": {"how": "$how"},
                "results": {"succeeded": [{"field": "code", "equals": 7, "result": "there"}, {"result": "odd"}],
                            "aborted": "lost", "rejected": "refused"}},
        "arm": {"service": "/arm", "type": "std_srvs/srv/SetBool", "request": {"data": "$on"},
                "results": [{"field": "success", "equals": False, "result": "armed"}, {"result": "rejected"}]},
        "say": {"topic": "say", "type": "std_msgs/msg/String", "message": {"data": "$text"}},
    },
    "variables": {
        "battery": {"topic": "/battery", "type": "std_msgs/msg/Float32", "field": "data", "hysteresis": 0.1,
                    "values": [{"value": "Critical", "below": 0.2}, {"value": "Good"}]},
    },
}


class Case(Missions, ros.Ros):
    platform = PLATFORM


class Goals(Case):
    def setUp(self):
        super().setUp()
        self.start_server()

    def test_a_goal_ends_as_the_platform_file_says(self):
        self.mission(" ".join(FLY.format(kind) for kind in (how.SUCCEED, how.ABORT, how.REJECT, how.TWICE)) + OTHERS)
        self.begin()
        self.ends("succeeds with `there`", "fails with `lost`", "fails with `refused`", "succeeds with `armed`")
        self.sees("said hello")
        self.no_faults()

    def test_a_goal_is_cancelled_and_its_feedback_does_not_count(self):
        for kind in (how.WAIT, how.TALK, how.LATE_RESULT, how.NO_ANSWER, how.REFUSE_ONCE):
            with self.subTest(kind):
                self.events.write_text("")
                self.fly(kind, STOP_AFTER)
                self.stop_when(f"accepted {kind}")
                self.ends("asks its action to stop")
                self.sees(f"ended {kind}")
                self.no_faults()

    def test_an_interrupt_between_sent_and_accepted_leaves_nothing_running(self):
        self.fly(how.LATE_ACCEPT, STOP_AFTER)
        self.stop_when(f"goal {how.LATE_ACCEPT}")
        self.until_it_says("asks its action to stop")
        self.tell("decide")
        self.ends()
        self.sees(f"ended {how.LATE_ACCEPT}")
        self.assertNotIn(f"unknown {how.LATE_ACCEPT}", self.log())  # no cancel before
        self.no_faults()

    def test_an_interrupt_before_a_goal_is_rejected(self):
        self.fly(how.LATE_REJECT, STOP_AFTER)
        self.stop_when(f"goal {how.LATE_REJECT}")
        self.until_it_says("asks its action to stop")
        self.tell("decide")
        self.ends()
        self.no_faults()

    def test_a_goal_that_is_accepted_after_its_skill_was_given_up_is_cancelled(self):
        self.fly(how.LATE_ACCEPT, STOP_AFTER.replace("(fly.interrupt)", "(fly.interrupt) (arm on true) (^ (battery Silent))"))
        self.stop_when(f"goal {how.LATE_ACCEPT}")
        self.until_it_says("does not stop")
        self.tell("decide")
        until(lambda: f"ended {how.LATE_ACCEPT}" in self.log(), "the cancel")

    def test_a_server_that_refuses_every_cancel(self):
        self.fly(how.DEAF, STOP_AFTER)
        self.stop_when(f"accepted {how.DEAF}")
        self.ends("does not stop", code=1)
        self.assertGreater(self.log().count(f"cancel {how.DEAF}"), 1)

    def test_a_result_that_is_gone_before_it_is_asked_for(self):
        self.fly(how.GONE)
        self.ends("its action failed", code=1)

    def test_a_result_that_is_never_answered(self):
        self.fly(how.NO_RESULT)
        self.ends("its action failed: the goal was succeeded, and its result was lost", code=1)
        self.assertEqual(self.log().count(f"asked {how.NO_RESULT}"), 2)

    def test_a_server_that_dies_ends_its_goals_and_returns(self):
        for kind in (how.DIE, how.LEAVE):
            with self.subTest(kind):
                self.mission(FLY.format(kind) + FLY.format(how.SUCCEED))
                self.begin()
                self.server.wait(60)
                self.start_server()
                self.ends("its action failed: the action server", "succeeds with `there`", code=1)

    def test_a_server_that_dies_when_its_goal_is_cancelled(self):
        self.fly(how.DIE_ON_CANCEL, STOP_AFTER)
        self.stop_when(f"accepted {how.DIE_ON_CANCEL}")
        self.ends("asks its action to stop")
        self.no_faults()

    def test_a_server_that_does_not_return(self):
        self.mission(FLY.format(how.LEAVE) + FLY.format(how.SUCCEED))
        self.begin()
        self.ends("its action failed: the action server `/fly` is not there", code=1)

    def test_a_goal_of_an_adapter_that_was_killed_is_cancelled_by_the_next(self):
        self.mission(FLY.format(how.WAIT) + FLY.format(how.SUCCEED), restarts=1, restart_delay=0)
        self.begin()
        until(lambda: f"accepted {how.WAIT}" in self.log(), "the goal")
        os.kill(self.adapter(), signal.SIGKILL)
        self.ends("its action has ended with the ROS adapter", "succeeds with `there`", code=1)
        self.sees(f"ended {how.WAIT}")
        self.assertLess(self.log().index(f"ended {how.WAIT}"), self.log().index(f"goal {how.SUCCEED}"))

    def test_a_goal_of_a_run_that_was_killed_is_cancelled_by_the_next(self):
        self.fly(how.WAIT)
        until(lambda: f"accepted {how.WAIT}" in self.log(), "the goal")
        for process in (self.adapter(), self.running.pid):
            os.kill(process, signal.SIGKILL)
        self.mission("(^ (battery Critical))")
        self.begin()
        until(lambda: f"ended {how.WAIT}" in self.log(), "the cancel")
        self.tell(0.1)
        self.ends("cancelled a goal on /fly that an earlier adapter has left")

    def adapter(self):
        found = subprocess.run(["ps", "-o", "pid=", "--ppid", str(self.running.pid)], capture_output=True, text=True)
        return int(found.stdout)

    def test_goals_stop_when_the_executor_is_killed(self):
        self.fly(how.WAIT)
        until(lambda: f"accepted {how.WAIT}" in self.log(), "the goal")
        os.kill(self.running.pid, signal.SIGKILL)
        until(lambda: f"ended {how.WAIT}" in self.log(), "the cancel")

    def test_two_runs_share_a_server_and_do_not_cancel_each_other(self):
        self.fly(how.WAIT, STOP_AFTER)
        until(lambda: f"accepted {how.WAIT}" in self.log(), "the goal")
        first, path = self.running, self.path
        self.path = path / "second"
        self.path.mkdir()
        self.mission(FLY.format(how.SUCCEED) + "(^ (battery Good) :timeout 10)")
        self.begin()
        self.ends("succeeds with `there`")
        self.assertNotIn(f"cancel {how.WAIT}", self.log())
        self.running, self.path = first, path
        self.stop_when(f"accepted {how.WAIT}")
        self.ends("asks its action to stop")

    def test_a_variable_has_hysteresis(self):
        self.mission("(^ (battery Good)) (^ (battery Critical)) (^ (battery Good))")
        self.begin()
        self.tell(0.5)
        self.until_it_says("battery_good")
        self.tell(0.25, 0.1, 0.25, "nan", 0.19, 0.31)
        self.ends()
        events = [line["actor"] for line in self.lines if str(line.get("actor", "")).startswith("battery_")]
        self.assertEqual(events, ["battery_good", "battery_critical", "battery_good"])

    def test_silence_is_a_value(self):
        battery = {**PLATFORM["variables"]["battery"], "timeout": 0.3, "silent": "Silent"}
        self.mission("(^ (battery Silent))", variables={"battery": battery})
        self.begin()
        self.ends()


class Errors(Case):
    def test_what_ros_does_not_have_is_reported_before_the_run(self):
        self.mission(OTHERS, startup=8)
        self.fails("mission.proskill:6:11: error: there is no action server `/fly` of type `test_msgs/action/Fly` in domain ",
                   " on this machine")
        for change, why in (({"type": "test_msgs/action/Fl"}, "there is no type `test_msgs/action/Fl`"),
                            ({"goal": {"hows": 1}}, "there is no field `hows`: no `hows`; it has how"),
                            ({"goal": {"how": "x"}}, "field `how` of type int32 cannot be 'x'"),
                            ({"goal": {"how": 1.5}}, "field `how` of type int32 cannot be 1.5")):
            with self.subTest(why):
                actions = {**PLATFORM["actions"], "fly": {**PLATFORM["actions"]["fly"], **change}}
                self.mission(OTHERS, actions=actions)
                self.fails("mission.proskill:6:11: error: ", why)

    def test_a_result_of_another_type(self):
        self.start_server()
        types = {"test_msgs/action/Fly": {"goal": {"how": "int32"}, "result": {"code": "int32", "text": "string"}}}
        self.mission(FLY.format(how.SUCCEED), types=types)
        self.begin()
        self.ends("its action failed: the result is not one of `test_msgs/action/Fly` as it is defined here", code=1)

    def test_a_domain_that_cannot_be(self):
        self.mission(OTHERS)
        self.surroundings = {**self.surroundings, "ROS_DOMAIN_ID": "300"}
        self.fails("ROS_DOMAIN_ID must be a number from 0 to 232")


if __name__ == "__main__":
    main(ros.why_not())
