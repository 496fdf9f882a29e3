#!/usr/bin/env bash
# Draws the pictures of README and docs again, with the program as it is built now. Takes no arguments.
set -euo pipefail
cd "$(dirname "$0")/.."

cmake --preset release >/dev/null
cmake --build --preset release --target headland

results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
build/headland evaluate examples/demo.yaml -o "$results" --quiet
cp "$results"/{field,view,energy}.png docs/images/
render=(build/headland render "$results" -q)
"${render[@]}" --view chase --at 16:40 --size 1280x720 -o docs/images/chase.png
"${render[@]}" --view event:tightest_turn --size 1280x720 -o docs/images/event_tightest_turn.png
"${render[@]}" --view map --overlay slip --size 1280x800 -o docs/images/map_slip.png
"${render[@]}" --view elevation --overlay power --at 16:40 --size 1280x800 -o docs/images/elevation.png
build/headland render "$results" -q --video "$results/run.mp4" --from 16:00 --to 16:40 --speed 40 --size 960x540
ffmpeg -v error -y -ss 0.9 -i "$results/run.mp4" -frames:v 1 docs/images/video_frame.png
node web/pictures.js "$results/report.html" docs/images
build/headland vehicle check four_wheel_steer_robot -o docs/images/four_wheel_steer_robot.png >/dev/null
build/headland vehicle check utility_tractor --soil tilled --charts docs/images/utility_tractor_charts.svg \
  >/dev/null
build/headland measure --vehicle transplanter --soil firm -o "$results/costs" --quiet
cp "$results/costs/costs.png" docs/images/
build/headland compare examples/compare.yaml -o "$results/compare" --quiet
cp "$results/compare/plans_field_B.png" docs/images/compare_plans.png
cp "$results/compare/convergence_field_B.png" docs/images/compare_convergence.png
# An audit that fails exits with 1.
build/headland audit examples/demo.yaml --path examples/straight_rows.csv -o "$results/audit" --quiet ||
  test $? = 1
cp "$results/audit/audit.png" docs/images/
build/headland evaluate examples/field_b.yaml -o "$results/grid" --quiet
cp "$results/grid/field.png" docs/images/grid_drive.png
build/headland job examples/job.yaml -o "$results/job" --quiet
build/headland audit "$results/job/scenario.yaml" --path "$results/job/path.geojson" -o "$results/job_audit" --quiet
cp "$results/job_audit/audit.png" docs/images/job.png

# docs/planning.md: the same field by other parameters of its planner, which stand on its last line.
planning() {
  local name=$1 scenario=$2
  build/headland plan "$scenario" -o "$results/$name" --quiet
  build/headland audit "$results/$name/scenario.yaml" --path "$results/$name/path.geojson" \
    -o "$results/${name}_audit" --quiet
  cp "$results/${name}_audit/audit.png" "docs/images/planning_$name.png"
}
with() {
  sed "s/headland_corners: covered/$2/" examples/irregular.yaml >"$results/$1.yaml"
  planning "$1" "$results/$1.yaml"
}
planning covered examples/irregular.yaml
with rounded "headland_corners: rounded"
with ab_line "ab_line: [[20, 20], [120, 90]]"
with skip "swath_order: skip"
with spiral "swath_order: spiral"
with optimised "swath_order: optimised"
planning parts examples/two_arms.yaml
planning edges examples/irregular_edges.yaml
planning off_rows examples/slanted_ends.yaml
