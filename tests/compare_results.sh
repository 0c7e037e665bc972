#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Do two builds give the same results, bit for bit? Runs pcl_msf_scene_flow of both on
# every case of the data folders and on generated scenes of two seeds, and compares
# hashes of all that is written, times left out. Fails when any differ.
set -euo pipefail

usage () {
  cat >&2 <<'USAGE'
usage: bash tests/compare_results.sh BEFORE AFTER [DATA...]
       bash tests/compare_results.sh --table TOOLS [DATA...] > TABLE
  BEFORE, AFTER: the folder of a build's tools (BUILD/examples), or a TABLE of it
  DATA:          a folder of cases: folders with camera.txt and depth_K or cloud_K
Environment: PCL_MSF_RUNS, what is run of each case (default: "pairs window track"):
  pairs       each pair of adjacent frames
  window      windows of three frames
  track       the tracker, windows of three frames
  background  each pair with --static-background
USAGE
  exit 2
}

runs="${PCL_MSF_RUNS:-pairs window track}"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT

# Seed 1: easy motion without noise; seed 2: large motion, a sensor's noise.
generate () { # TOOLS FOLDER
  local scene
  local size=(-frames 3 -width 320 -height 240)
  for scene in static_room multi_body articulated hand bending breathing street \
               texture_poor thin_structures; do
    "$1/pcl_msf_synthesize" "$2/${scene}_1" -scene "$scene" -seed 1 "${size[@]}"
    "$1/pcl_msf_synthesize" "$2/${scene}_2" -scene "$scene" -seed 2 "${size[@]}" \
      -motion large -sensor kinect
  done > /dev/null
}

# JSON without times and the hash of tuned values, which names and new values change, all
# numbers spelled one way: writers differ in "1", "1.0", "1e-04".
numbers () { # FILE
  sed '/"seconds": {/,/}/d; /"seconds":/d; /"tuning_hash":/d' "$1" |
    perl -pe 's/-?\d+(\.\d+)?(e[+-]?\d+)?/sprintf ("%.17g", $&)/ge'
}

# Names and contents of the results; the picture files are made of them.
contents () { # FOLDER
  local file
  for file in "$1"/*; do
    echo "${file##*/}"
    case "$file" in
      *.json) numbers "$file" ;;
      *.flo | *.pcd | *.txt | */labels*.png | */visib*.png) cat "$file" ;;
    esac
  done
}

run_case () { # TOOLS CASE OPTIONS...
  local out="$scratch/results"
  rm -rf "$out"
  if "$1/pcl_msf_scene_flow" "${@:2}" --output "$out" --quiet > "$scratch/log" 2>&1; then
    contents "$out" | sha256sum | cut -c1-16
  else
    echo failed
  fi
}

table () { # TOOLS DATA...
  local folder run frames options
  for folder in "$@"; do
    [ -d "$folder" ] || { echo "compare_results: $folder is no folder" >&2; exit 2; }
  done
  rm -rf "$scratch/generated"
  mkdir "$scratch/generated"
  generate "$1" "$scratch/generated"
  for folder in $(printf '%s/*/ ' "${@:2}" "$scratch/generated"); do
    frames=$(find "$folder" -maxdepth 1 \( -name 'depth_*' -o -name 'cloud_*' \) | wc -l)
    for run in $runs; do
      case "$run" in
        pairs) options=(--window 2) ;;
        window) options=(--window 3) ;;
        track) options=(--window 3 --track) ;;
        background) options=(--window 2 --static-background 1) ;;
        *) usage ;;
      esac
      [ "$frames" -ge "${options[1]}" ] || continue
      printf '%s %s %s\n' "$(basename "$folder")" "$run" \
        "$(run_case "$1" "$folder" "${options[@]}")"
    done
  done
}

[ $# -ge 2 ] || usage
if [ "$1" = --table ]; then
  table "${@:2}"
  exit
fi
for side in "$1" "$2"; do
  if [ -f "$side" ]; then
    cat "$side"
  else
    table "$side" "${@:3}"
  fi > "$scratch/$([ -e "$scratch/before" ] && echo after || echo before)"
done
# Cases of one side only stand with a dash on the other.
join -a 1 -a 2 -e - -o 0,1.2,2.2 \
     <(sed 's/ /:/' "$scratch/before" | sort) <(sed 's/ /:/' "$scratch/after" | sort) |
  awk '{ same = $2 == $3 && $2 != "failed"; different += !same
         printf "%-44s %-16s %-16s %s\n", $1, $2, $3, same ? "same" : "DIFFERENT" }
       END { printf "%d cases, %d different\n", NR, different; exit different > 0 }'
