"""Performs the actions of a program by action servers, services and topics of ROS 1."""

import os
import sys

if __package__ in (None, ""):  # started by its path, without being installed
    sys.path[0] = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, os.pardir)

from proskill.connection import Connection  # noqa: E402

connection = Connection.of_this_process()
try:
    import actionlib_msgs  # noqa: F401
    import rospy  # noqa: F401
except ImportError as error:
    connection.send("failed", text=f"ROS 1 is not installed ({error}): apt-get install "
                                   "python3-rospy python3-actionlib")
    sys.exit(1)

from proskill.ros1.adapter import Adapter  # noqa: E402

status = Adapter(connection).run()
sys.stderr.flush()
os._exit(status)  # rospy has threads that wait for the network
