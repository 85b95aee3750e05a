"""The platform of kind `ros2`: docs/ros/ros2.md of ProSkill. `proskill run` starts it."""
