"""The platform of kind `ros1`: docs/ros1.md of ProSkill. `proskill run` starts it."""
