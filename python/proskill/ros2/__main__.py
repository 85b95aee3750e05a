"""Performs the actions of a program by action servers, services and topics of ROS 2."""

import os
import sys

if __package__ in (None, ""):  # started by its path, without being installed
    sys.path[0] = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, os.pardir)

from proskill.connection import Connection  # noqa: E402
from proskill.ros2.adapter import Adapter  # noqa: E402

status = Adapter(Connection.of_this_process()).run()
sys.stderr.flush()
os._exit(status)  # DDS has threads that wait for the network
