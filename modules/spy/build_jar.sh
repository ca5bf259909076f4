#!/bin/bash
# build_jar.sh OUT.jar LCM_JAR CHART_JAR LCMTYPES_FOLDER PLUGIN_FOLDER: the message types in Java and the plugin of lcm-spy, in one
# jar that starts lcm-spy: `java -jar OUT.jar`.
set -euo pipefail
out=$1 lcm_jar=$2 chart_jar=$3 types=$4 plugin=$5
for tool in lcm-gen javac jar; do
  command -v "$tool" >/dev/null || { echo "the jar of lcm-spy needs $tool (packages-tools.txt)" >&2; exit 1; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
lcm-gen -j --jpath "$folder/java" "$types"/*.lcm
find "$folder/java" "$plugin" -name '*.java' >"$folder/sources"
javac -nowarn -cp "$lcm_jar" -d "$folder/classes" "@$folder/sources"
printf 'Main-Class: citrine_spy.SpyMain\nClass-Path: file://%s file://%s\n' "$lcm_jar" "$chart_jar" >"$folder/manifest"
mkdir -p "$(dirname "$out")"
jar cfm "$out" "$folder/manifest" -C "$folder/classes" .
