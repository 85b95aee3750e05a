"""What the platforms `ros1` and `ros2` have in common. Nothing here needs ROS."""
