#!/usr/bin/env bash
# Sets headland up on a bare Debian 12 and evaluates the example field: plans it, drives the plan in
# physics, judges the run and draws it. Takes no arguments.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_deps.sh
cmake --preset release >/dev/null
cmake --build --preset release --target headland

status=0
build/headland evaluate examples/demo.yaml -o out/demo || status=$?
# 1 is a run whose verdict is FAIL: a result like any other.
[ "$status" -le 1 ] || exit "$status"
echo
echo "Open out/demo/report.html in a browser, or look at the pictures:"
echo "  out/demo/field.png    from above: what was covered how often, planned and driven path"
echo "  out/demo/view.png     the terrain with the driven swaths and the machine where it ended"
echo "  out/demo/energy.png   what every metre of the way cost the battery"
