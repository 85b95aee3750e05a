#!/usr/bin/env bash
# Installs the planners of PyPI, with which `proskill plan` is tested, in a folder of the cache. Nothing else changes.
set -euo pipefail

folder=${XDG_CACHE_HOME:-$HOME/.cache}/proskill/planners
# Whole once the last line has run: an interrupted installation begins anew.
[ ! -e "$folder/complete" ] || exit 0

rm -rf "$folder"
mkdir -p "${folder%/*}"
/usr/bin/python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check --timeout 10 --retries 1 \
  unified-planning==1.3.0 up-aries==0.5.0 up-tamer==1.1.6
"$folder/bin/python" -c 'import unified_planning, up_aries, up_tamer'
touch "$folder/complete"
