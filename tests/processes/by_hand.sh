#!/bin/bash
# Flies the smoke mission by hand on a bus of its own: every module started on its own, the owner of time first and the rest in an
# odd order and late; then, in flight, each module but the owner of time is stopped and started again. The mission completes all the
# same. Exit code 77: no private network namespace may be made here.
set -u
source "$(dirname "$0")/../support/private_bus.sh"
bin=$1
folder=$(mktemp -d)
declare -A pids=()
trap 'kill -KILL "${pids[@]}" $launcher 2>/dev/null; wait; rm -rf "$folder"' EXIT
fail() { echo "$1"; cat "$folder"/*.log; exit 1; }

"$bin/launch" run smoke --by-hand --out "$folder/run" >"$folder/launcher.log" 2>&1 &
launcher=$!
mission=$folder/run/mission.toml
start() { "$bin/$1" -P "$mission" ${2:+--uav $2} >>"$folder/$1${2:-}.log" 2>&1 & pids[$1${2:-}]=$!; }
restart() { # NAME SIGNAL [UAV]
  kill -"$2" "${pids[$1${3:-}]}"
  wait "${pids[$1${3:-}]}" 2>/dev/null
  start "$1" "${3:-}"
}
for _ in $(seq 300); do [ -s "$mission" ] && grep -q view_planner "$folder/launcher.log" && break; sleep 0.1; done
start uav_dynamics
sleep 1
start topdown_renderer
start trajectory_smoother 2
start view_planner 1
sleep 1
start map_fusion
start view_planner 2
start lidar_emulator
start trajectory_smoother 1

sleep 9
restart view_planner KILL 1
sleep 1
restart trajectory_smoother KILL 1
restart lidar_emulator KILL
sleep 1
restart topdown_renderer KILL
restart map_fusion INT # it writes its map first
for _ in $(seq 1500); do kill -0 $launcher 2>/dev/null || break; sleep 0.1; done
kill -0 $launcher 2>/dev/null && fail "the mission does not end"
wait $launcher
code=$?
launcher=
[ $code -eq 0 ] || fail "the launcher ended with $code"
grep -q surface_complete "$folder/launcher.log" || fail "the surface is not complete"
for module in "${!pids[@]}"; do wait "${pids[$module]}" || fail "$module failed"; done
pids=()
for file in metrics.json mission.lcmlog mesh.ply map.tsdf topdown.png report.html; do
  [ -s "$folder/run/$file" ] || fail "no $file"
done
tail -n 12 "$folder/launcher.log"
