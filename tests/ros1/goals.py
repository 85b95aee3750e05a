"""Goals, services, topics and faults of a platform `ros1`, with a real master and a real action server.

usage: goals.py PROGRAM
"""

import os
import signal
import subprocess

import ros
import server_goals as how
from missions import FLY, OTHERS, STOP_AFTER, Missions
from runs import end, main, until

PLATFORM = {
    "kind": "ros1",
    "patience": 3,
    "startup": 30,
    "actions": {
        "fly": {"action": "/fly", "type": "actionlib/TestAction", "goal": {"goal": "$how"},
                "results": {"succeeded": [{"field": "result", "equals": 7, "result": "there"}, {"result": "odd"}],
                            "aborted": "lost", "rejected": "refused"}},
        "arm": {"service": "/arm", "type": "std_srvs/SetBool", "request": {"data": "$on"},
                "results": [{"field": "success", "equals": False, "result": "armed"}, {"result": "rejected"}]},
        "say": {"topic": "/say", "type": "std_msgs/String", "message": {"data": "$text"}},
    },
    "variables": {
        "battery": {"topic": "/battery", "type": "std_msgs/Float32", "field": "data", "hysteresis": 0.1,
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
        for kind in (how.WAIT, how.PEND, how.TALK, how.LATE_RESULT):
            with self.subTest(kind):
                self.events.write_text("")
                self.fly(kind, STOP_AFTER)
                self.stop_when(f"goal {kind}")
                self.ends("asks its action to stop")
                self.sees(f"ended {kind}")
                self.no_faults()

    def test_a_cancel_that_overtakes_its_goal_leaves_nothing_running(self):
        self.fly(how.LATE_GOAL, STOP_AFTER)
        self.stop_when("seen")
        self.ends("asks its action to stop")
        self.sees("cancelled")
        self.assertNotIn(f"goal {how.LATE_GOAL}", self.log())
        self.no_faults()

    def test_a_result_that_is_gone_before_it_is_asked_for(self):
        self.fly(how.LOSE_RESULT)
        self.ends("its action failed: the goal was succeeded, and its result was lost", code=1)

    def test_a_server_that_dies_ends_its_goals_and_returns(self):
        self.mission(FLY.format(how.DIE) + FLY.format(how.SUCCEED))
        self.begin()
        self.server.wait(30)
        self.start_server()
        self.ends("its action failed: the action server", "succeeds with `there`", code=1)

    def test_a_server_that_dies_when_its_goal_is_cancelled(self):
        self.fly(how.DIE_ON_CANCEL, STOP_AFTER)
        self.stop_when(f"goal {how.DIE_ON_CANCEL}")
        self.ends("asks its action to stop")
        self.no_faults()

    def test_a_server_that_does_not_return(self):
        self.mission(FLY.format(how.DIE) + FLY.format(how.SUCCEED))
        self.begin()
        self.ends("its action failed: the action server `/fly` is not there", code=1)

    def test_a_goal_of_an_adapter_that_was_killed_is_cancelled_by_the_next(self):
        self.mission(FLY.format(how.WAIT) + FLY.format(how.SUCCEED), restarts=1, restart_delay=0)
        self.begin()
        until(lambda: f"goal {how.WAIT}" in self.log(), "the goal")
        os.kill(self.adapter(), signal.SIGKILL)
        until(lambda: f"ended {how.WAIT}" in self.log(), "the cancel")
        self.ends("its action has ended with the ROS adapter", "succeeds with `there`", code=1)

    def test_a_second_mission_does_not_end_the_first(self):
        self.fly(how.WAIT, STOP_AFTER)
        self.sees(f"goal {how.WAIT}")
        first, early = self.running, self.early
        self.fails("a node `/proskill` runs already", "let `node` name another one here")
        self.mission(FLY.format(how.SUCCEED), node="second")
        self.begin()
        self.ends("succeeds with `there`")
        self.running, self.early = first, early
        self.stop_when(f"goal {how.WAIT}")
        self.ends("asks its action to stop")
        self.no_faults()

    def adapter(self):
        found = subprocess.run(["ps", "-o", "pid=", "--ppid", str(self.running.pid)], capture_output=True, text=True)
        return int(found.stdout)

    def test_goals_stop_when_the_executor_is_killed(self):
        self.fly(how.WAIT)
        until(lambda: f"goal {how.WAIT}" in self.log(), "the goal")
        os.kill(self.running.pid, signal.SIGKILL)
        until(lambda: f"ended {how.WAIT}" in self.log(), "the cancel")

    def test_a_subscriber_that_does_not_read_holds_no_skill_and_gets_nothing_after_its_stop(self):
        much = "x" * 400_000  # soon fills what the connection holds; on a busy machine each takes a while
        self.mission(f"""(label again) (race ((say text "{much}")) ((^ 4))) (if (/= say.status interrupted) (goto again))
            (race ((say text "late")) ((^ 0.3))) (^ (battery Critical)) (say text "end")""")
        self.begin()
        self.until_it_says("succeeds")
        self.server.send_signal(signal.SIGSTOP)
        self.until_it_says('(say \\"late')
        self.until_it_says('"stops":"say"')
        self.server.send_signal(signal.SIGCONT)
        self.tell(0.1)
        self.ends()
        self.sees("said end")
        self.assertNotIn("said late", self.log())

    def test_a_variable_has_hysteresis(self):
        self.mission("(^ (battery Good)) (^ (battery Critical)) (^ (battery Good))")
        self.begin()
        self.tell(0.5, 0.25, 0.1, 0.25, "nan", 0.19, 0.31)
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
        self.fails("mission.proskill:6:11: error: there is no action server `/fly` of type `actionlib/TestAction`")
        for change, why in (({"type": "actionlib/Tes"}, "there is no type `actionlib/Tes`"),
                            ({"type": "std_msgs/Float32"}, "is not the type of an action"),
                            ({"goal": {"goals": 1}}, "has no field `goals`; it has goal"),
                            ({"goal": {"goal": "x"}}, "field `goal` of `actionlib/TestGoal`")):
            with self.subTest(why):
                actions = {**PLATFORM["actions"], "fly": {**PLATFORM["actions"]["fly"], **change}}
                self.mission(OTHERS, actions=actions)
                self.fails("mission.proskill:6:11: error: ", why)

    def test_a_master_that_is_not_there(self):
        self.mission(OTHERS)
        self.surroundings = {**self.surroundings, "ROS_MASTER_URI": f"http://127.0.0.1:{ros.free_port()}"}
        self.fails("no ROS master answers at http://127.0.0.1:", "start roscore")


class Master(Case):
    def test_what_is_connected_goes_on_without_the_master(self):
        self.start_server()
        self.fly(how.WAIT, STOP_AFTER)
        until(lambda: f"goal {how.WAIT}" in self.log(), "the goal")
        end(self.master)
        self.stop_when(f"goal {how.WAIT}")
        self.ends("asks its action to stop")
        self.sees(f"ended {how.WAIT}")


if __name__ == "__main__":
    main(ros.why_not())
