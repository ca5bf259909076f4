#!/bin/bash
# Flies the toy mission as ten processes on a bus of their own, records it, and compares the log with that of one
# process. Exit code 77: no private network namespace may be made here.
set -u
source "$(dirname "$0")/../../support/private_bus.sh"
program=$1
folder=$(mktemp -d)
trap 'kill $pids $logger 2>/dev/null; wait; rm -rf "$folder"' EXIT
pids= logger=
"$program" record "$folder/log" & logger=$!
fly() { "$program" "$@" -O launch.pace=0 & pids="$pids $!"; }
sleep 1
fly lidar_emulator
fly map_fusion
fly topdown_renderer
for uav in 1 2 3; do
  fly view_planner --uav $uav
  fly trajectory_smoother --uav $uav
done
"$program" uav_dynamics -O launch.pace=0 || { echo "uav_dynamics failed"; exit 1; }
for pid in $pids; do wait $pid || { echo "a module failed"; exit 1; }; done
pids=
sleep 1
kill -INT $logger; wait $logger; logger=
processes=$("$program" digest "$folder/log")
one=$("$program" in_process)
echo "processes $processes, one process $one"
[ "$processes" = "$one" ]
