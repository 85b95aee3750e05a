"""The node in `ros2 node list`: which topics and services of this participant are its own.

What is published has another form before ROS 2 Iron, under the same name, so it is published only if ROS_DISTRO says
which ROS 2 the others are.
"""

from __future__ import annotations

import os
from typing import Any

from proskill.ros2.cdr import Array, Struct
from proskill.ros2.dds import RELIABLE, TRANSIENT_LOCAL
from proskill.ros2.node import Node, has_settled

_BEFORE_IRON = ("dashing", "eloquent", "foxy", "galactic", "humble")
_PARTICIPANT = bytes((0, 0, 1, 0xC1))  # the last bytes of a participant's GUID


class Presence:
    """Publishes it for each participant that comes.

    \\pre the node has all its endpoints
    """

    def __init__(self, node: Node, namespace: str, name: str) -> None:
        distribution = os.environ.get("ROS_DISTRO", "")
        if not distribution:
            return
        size = 24 if distribution in _BEFORE_IRON else 16
        self._node, self._type = node, _info(size)
        self._writer = node.advertise("/ros_discovery_info", "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_",
                                      RELIABLE | TRANSIENT_LOCAL, "")
        readers, writers = node.guids()
        own = {"node_namespace": "/" + namespace.strip("/"), "node_name": name,
               "reader_gid_seq": [_gid(guid, size) for guid in readers],
               "writer_gid_seq": [_gid(guid, size) for guid in writers]}
        participant = node.guid(self._writer)[:12] + _PARTICIPANT
        self._message = {"gid": _gid(participant, size), "node_entities_info_seq": [own]}
        self._known: set[bytes] = set()
        node.ticks.append(self._tick)

    def _tick(self) -> None:
        there = {host for host, since in self._node.others(self._writer).items() if has_settled(since)}
        if there - self._known:
            self._node.write(self._writer, self._type, self._message)
        self._known = there


def _gid(guid: bytes, size: int) -> Any:
    return {"data": list(guid.ljust(size, b"\0"))}


def _info(size: int) -> Struct:
    gid = Struct({"data": Array("uint8", size)}, {})
    of_node = Struct({"node_namespace": "string", "node_name": "string", "reader_gid_seq": Array(gid, None),
                      "writer_gid_seq": Array(gid, None)}, {})
    return Struct({"gid": gid, "node_entities_info_seq": Array(of_node, None)}, {})
