"""Platforms for `proskill run` in Python: functions that perform the actions of a program's skills.

    from proskill import Platform, Stop

    robot = Platform()

    @robot.action
    def fly(height: float, stop: Stop) -> str:
        motors.climb(height)
        while motors.busy():
            stop.sleep(0.05)  # raises Stopped when the skill is interrupted
        return "at_height"

    robot.run()

The platform file, for `proskill run --platform FILE`:

    {"kind": "process", "command": ["python3", "robot.py"]}
"""

from proskill.actions import Platform
from proskill.stop import Stop, Stopped

__all__ = ["Platform", "Stop", "Stopped"]
