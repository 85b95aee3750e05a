"""A simulated drone: performs the actions of drone.proskill and reports its sensors.

    proskill run --platform examples/drone/robot/platform.json examples/drone/drone.proskill
"""

import asyncio
import math
import os
import sys
import threading
from typing import Literal

# if the package is not installed, it is found in the tree
sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../python"))
from proskill import Platform, Stop  # noqa: E402

robot = Platform()


class Drone:
    """Position in metres, time in seconds, and charge of the battery from 0 to 1."""

    SPEED = 1.5

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.position = (0.0, 0.0, 0.0)
        self.charge = 1.0

    def fly_to(self, target: tuple[float, float, float], stop: Stop) -> None:
        """Raises Stopped when asked to stop, and stays at its position."""
        step = 0.1
        while (left := math.dist(self.position, target)) > 0:
            stop.sleep(step)
            part = min(1.0, self.SPEED * step / left)
            with self.lock:
                self.position = tuple(a + part * (b - a) for a, b in zip(self.position, target))
                self.charge -= 0.0005


drone = Drone()


@robot.background
def sensors(stop: Stop) -> None:
    """Finds the satellites after a second; reads the battery every half second."""
    stop.sleep(1)
    robot.report("localization_status_to_valid")
    told = "good"
    while not stop.wait(0.5):
        charge = "critical" if drone.charge < 0.1 else "low" if drone.charge < 0.3 else "good"
        if charge != told:
            robot.report(f"battery_to_{charge}")
        told = charge


@robot.action
def start_drone(stop: Stop) -> Literal["ready", "motors_dead"]:
    stop.sleep(1.5)
    return "ready"


@robot.action
def takeoff(height: float, duration: float, stop: Stop) -> Literal["at_altitude"]:
    x, y, _ = drone.position
    drone.fly_to((x, y, height), stop)
    robot.report("flight_status_to_in_air")
    return "at_altitude"


@robot.action
def goto_waypoint(x: float, y: float, z: float, yaw: float, duration: float,
                  stop: Stop) -> Literal["arrived"]:
    drone.fly_to((x, y, z), stop)
    robot.log(f"at ({x}, {y}, {z}), battery {drone.charge:.0%}")
    stop.sleep(22)  # the camera needs time
    return "arrived"


@robot.action
def landing(stop: Stop) -> Literal["landed"]:
    x, y, _ = drone.position
    drone.fly_to((x, y, 0.0), stop)
    stop.sleep(3)  # until the motors have stopped
    robot.report("flight_status_to_on_ground")
    return "landed"


@robot.action
def shutdown_drone(stop: Stop) -> Literal["stopped"]:
    stop.sleep(1.5)
    return "stopped"


@robot.action
async def camera_survey() -> Literal["target_found", "nothing_seen"]:
    await asyncio.sleep(90 / robot.speed)  # cancelled when asked to stop
    return "nothing_seen"


robot.run()
