#!/usr/bin/env bash
# fuzz/run.sh NAME SECONDS [SEED]: tries random bytes, beginning with the examples and with all that was
# found before. With a seed a fresh tree has nearly the same ones each time; nearly, as threads and
# addresses differ. Says nothing but the last line where all is well.
set -uo pipefail
cd "$(dirname "$0")/.."
name=$1 seconds=$2 seed=${3:-0} work=build/fuzz/corpus/$1
case $name in
proskill) seeds=(examples/drone examples/arm examples/lift examples/rover) ;;
fiacre) seeds=(examples/fiacre) ;;
bt) seeds=(examples/patrol) ;;
gen) seeds=(examples/gripper) ;;
rl) seeds=(examples/crane) ;;
*) seeds=() ;;
esac
# What was tried with profit stays in build/, so that the next run goes on from there.
mkdir -p "$work" build/fuzz/findings
log=build/fuzz/$name.log
words=()
if [ -f "fuzz/$name.dict" ]; then words=(-dict="fuzz/$name.dict"); fi
"build/fuzz/bin/fuzz_$name" "$work" "fuzz/corpus/$name" "${seeds[@]}" "${words[@]}" \
  -seed="$seed" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3000 -max_len=3000 -print_final_stats=1 \
  -artifact_prefix="build/fuzz/findings/$name-" >"$log" 2>&1
status=$?
runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
if [ $status -eq 0 ]; then
  echo "$name: ${runs} texts in $seconds s, nothing found"
else
  tail -n 40 "$log"
  echo "$name: found something. Mend it, and keep the text of build/fuzz/findings/ in fuzz/corpus/$name/"
fi
exit $status
