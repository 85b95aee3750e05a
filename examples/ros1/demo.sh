#!/usr/bin/env bash
# Starts a master and the robot on a port of its own, and runs the mission on them: demo.sh PROSKILL
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "$1")
port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
export ROS_HOME ROS_LOG_DIR ROS_MASTER_URI=http://127.0.0.1:$port ROS_IP=127.0.0.1
export ROS_PACKAGE_PATH=$here:/usr/share PYTHONDONTWRITEBYTECODE=1
ROS_HOME=$(mktemp -d)
ROS_LOG_DIR=$ROS_HOME/log
roslaunch --port "$port" "$here/robot.launch" >"$ROS_HOME/robot" 2>&1 &
robot=$!
trap 'kill $robot; wait $robot || true; rm -rf "$ROS_HOME"' EXIT
until (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do
  kill -0 $robot 2>/dev/null || { cat "$ROS_HOME/robot" >&2; exit 1; }
  sleep 0.1
done
"$program" run --platform "$here/platform.json" "${@:2}" "$here/patrol.proskill"
