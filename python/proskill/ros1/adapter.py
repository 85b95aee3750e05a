"""ROS 1 as the adapter to `proskill run` sees it."""

from __future__ import annotations

import os
import threading
import time
import xmlrpc.client
from http.client import HTTPException
from typing import Any

import rosgraph
import rospy

from proskill.connection import Connection
from proskill.ros import adapter
from proskill.ros1 import messages
from proskill.ros1.performers import ByGoal, ByService, ByTopic
from proskill.ros.sensing import is_number
from proskill.ros1.server import Server, quick

_TICK = 0.05  # seconds between two looks for silent topics
_LINGERS = 2.0  # seconds that a node may take to end after its run


def _is_running(master: str, node: str) -> bool:
    code, _, address = quick(master).lookupNode(node, node)
    if code != 1:
        return False
    try:
        quick(address).getPid(node)
    except (OSError, HTTPException, xmlrpc.client.Error):
        return False  # it was killed
    return True


class Adapter(adapter.Adapter):
    """A node that performs the actions of a program."""

    def __init__(self, connection: Connection) -> None:
        super().__init__(connection)
        self._servers: dict[str, Server] = {}
        self._sensing = threading.Lock()
        self.prefix = ""

    def _prepare(self, settings: dict[str, Any]) -> None:
        try:
            super()._prepare(settings)
        except rospy.ROSException as error:
            raise adapter.Unfit(str(error)) from None

    def _join(self, settings: dict[str, Any]) -> None:
        node = settings["node"]
        self.prefix = f"proskill/{node}/{os.getpid()}-{time.time_ns()}:"
        uri = rosgraph.get_master_uri()
        try:
            quick(uri).getPid("/" + node)
        except OSError as error:
            raise adapter.Unfit(f"no ROS master answers at {uri} ({error}): start roscore, or set "
                                 "ROS_MASTER_URI") from None
        self._take_name(uri, "/" + node)
        rospy.init_node(node, disable_signals=True)
        rospy.on_shutdown(self._on_shutdown)

    @staticmethod
    def _take_name(master: str, node: str) -> None:
        """A node that takes a name ends the node that has it, perhaps in the middle of a mission. One whose run was
        killed needs a moment to cancel its goals."""
        end = time.monotonic() + _LINGERS
        while _is_running(master, node):
            if time.monotonic() > end:
                raise adapter.Unfit(f"a node `{node}` runs already, perhaps of another mission: end it, or let `node` name another one here")
            time.sleep(_TICK)

    def _performer(self, mapping: dict[str, Any]) -> Any:
        if mapping["kind"] == "action":
            return ByGoal(mapping, self._servers, self)
        return (ByService if mapping["kind"] == "service" else ByTopic)(mapping, self)

    def _sense(self, mapping: dict[str, Any]) -> None:
        cls, path, cases = messages.message_class(mapping["type"]), mapping["field"], mapping["cases"]
        value = messages.field(cls(), path) if "[" not in path else None
        wants = any("below" in case or "above" in case for case in cases)
        if wants and value is not None and not is_number(value):
            raise adapter.Unfit(f"`{mapping['name']}`: field `{path}` of `{mapping['type']}` is not a number")
        sensor = self._new_sensor(mapping)

        def on_message(message: Any) -> None:
            try:
                with self._sensing:
                    self._report(sensor.take(messages.field(message, path), time.monotonic()))
            except (IndexError, TypeError):
                pass  # a list that is too short has no such value: silence

        rospy.Subscriber(mapping["topic"], cls, on_message, tcp_nodelay=True)

    def _begin_watch(self) -> None:
        threading.Thread(target=self._watch, daemon=True).start()

    def _watch(self) -> None:
        """Silent topics, and the master."""
        asked, is_there = 0.0, True
        while not self._is_ending:
            time.sleep(_TICK)
            with self._sensing:
                for sensor in self._sensors:
                    self._report(sensor.silence(time.monotonic()))
            if time.monotonic() - asked > 1.0:
                asked, was_there, is_there = time.monotonic(), is_there, self._has_master()
                if was_there and not is_there:
                    self.log("the ROS master is gone: what is connected goes on, and nothing new connects")

    @staticmethod
    def _has_master() -> bool:
        try:
            quick(rosgraph.get_master_uri()).getPid(rospy.get_name())
        except OSError:
            return False
        return True

    def _on_shutdown(self) -> None:
        if not self._is_ending:
            self._connection.send("failed", text="ROS has ended this node, perhaps for another one with its name")
            os._exit(1)

    def _leave(self) -> None:
        rospy.signal_shutdown("the run is over")
