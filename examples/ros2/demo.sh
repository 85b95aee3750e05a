#!/usr/bin/env bash
# Starts the robot in a domain of its own on the loopback interface, and runs the mission on it: demo.sh PROSKILL
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "$1")
library=$(dirname "$program")/../lib/libproskill_dds.so
[ -e "$library" ] || { echo "this proskill was built without Fast DDS (apt-get install libfastrtps-dev)" >&2; exit 1; }
export ROS_DOMAIN_ID=$((RANDOM % 100 + 1)) ROS_LOCALHOST_ONLY=1 PYTHONDONTWRITEBYTECODE=1
python3 "$here/robot.py" "$library" &
robot=$!
trap 'kill $robot; wait $robot || true' EXIT
"$program" run --platform "$here/platform.json" "${@:2}" "$(dirname "$here")/ros1/patrol.proskill"
