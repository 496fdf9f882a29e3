#!/usr/bin/env bash
# Draws one run with the program as built with OSMesa and as built with EGL and compares the pictures pixel by pixel:
# at most 0.1 % of the pixels may differ by more than 2 of 255 levels. Says of a video and the report whether they do.
# Takes the run's folder.
set -euo pipefail
run=$(realpath "${1:?usage: compare_gl.sh DIR}")
cd "$(dirname "$0")/.."

for gl in OSMESA EGL; do
  cmake --preset release -B "build-$gl" -DHEADLAND_TESTS=OFF -DHEADLAND_GL=$gl >/dev/null
  cmake --build "build-$gl" --target headland >/dev/null
done
pictures=$(mktemp -d)
trap 'rm -rf "$pictures"' EXIT
# Whether the files of both are the same.
told() {
  cmp -s "$pictures/OSMESA.$1" "$pictures/EGL.$1" && echo "same bytes" || echo "other bytes"
}
for view in map perspective chase elevation event:tightest_turn "map --overlay slip" "chase --overlay power"; do
  read -ra drawn <<<"$view"
  for gl in OSMESA EGL; do
    "build-$gl/headland" render "$run" --view "${drawn[@]}" --size 960x600 -o "$pictures/$gl.png" -q
  done
  # Mean of a black and white picture of the differences: the share of pixels that differ.
  share=$(ffmpeg -v error -i "$pictures/OSMESA.png" -i "$pictures/EGL.png" -filter_complex \
    "[0]format=gbrp[a];[1]format=gbrp[b];[a][b]blend=all_mode=difference,lutrgb=r='gt(val,2)*255':g='gt(val,2)*255':b='gt(val,2)*255',format=rgba" \
    -f rawvideo -pix_fmt rgba - | od -An -v -tu1 -w4 | awk '{n += ($1 + $2 + $3 > 0)} END {printf "%.5f", n / NR}')
  printf 'compare_gl.sh: %-24s %s of the pixels differ; %s\n' "$view" "$share" "$(told png)"
  awk -v share="$share" 'BEGIN {exit share > 0.001}' || { echo "compare_gl.sh: too many" >&2; exit 1; }
done
for gl in OSMESA EGL; do
  "build-$gl/headland" render "$run" -q --video "$pictures/$gl.mp4" --to 1:00 --speed 5 --size 640x360
  "build-$gl/headland" report "$run" -q -o "$pictures/$gl.html"
done
printf 'compare_gl.sh: video %s, report %s\n' "$(told mp4)" "$(told html)"
