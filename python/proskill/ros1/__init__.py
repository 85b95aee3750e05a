"""The platform of kind `ros1`: docs/ros/ros1.md of ProSkill. `proskill run` starts it."""
