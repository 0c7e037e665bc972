#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# From a bare Debian 12 machine to pictures: installs what is missing, builds Release,
# and registers a small synthetic articulated pair, or the pair that is given.
# Environment: PCL_MSF_BUILD_DIR, build directory (default: build);
#              PCL_MSF_DEMO_DIR, results (default: pcl_msf_demo in the present directory).
set -euo pipefail

usage () {
  cat >&2 <<'USAGE'
usage: bash cmake/demo.sh [COLOR0 DEPTH0 COLOR1 DEPTH1 CAMERA [DEPTH_SCALE]]
  CAMERA: a file "fx fy cx cy width height depth_scale", or FX,FY,CX,CY
  DEPTH_SCALE: units per metre of 16-bit depth, with FX,FY,CX,CY (default 1000)
USAGE
  exit 2
}

[ $# -eq 0 ] || [ $# -eq 5 ] || [ $# -eq 6 ] || usage
source "$(dirname "${BASH_SOURCE[0]}")/build_tree.sh"
demo_dir="${PCL_MSF_DEMO_DIR:-$PWD/pcl_msf_demo}"

# Sets camera and depth_scale from a camera file or from FX,FY,CX,CY.
read_camera () {
  if [ -f "$1" ]; then
    local fx fy cx cy width height
    read -r fx fy cx cy width height depth_scale < "$1" || [ -n "${depth_scale:-}" ] ||
      { echo "demo: $1 does not hold fx fy cx cy width height depth_scale" >&2; usage; }
    camera="$fx,$fy,$cx,$cy"
    depth_scale="${2:-$depth_scale}"
  elif [[ "$1" =~ ^[^,]+,[^,]+,[^,]+,[^,]+$ ]]; then
    camera="$1"
    depth_scale="${2:-1000}"
  else
    echo "demo: $1 is neither a camera file nor FX,FY,CX,CY" >&2
    usage
  fi
}

if [ $# -gt 0 ]; then
  for file in "${@:1:4}"; do
    [ -r "$file" ] || { echo "demo: cannot read $file" >&2; usage; }
  done
  images=("${@:1:4}")
  read_camera "$5" "${6:-}"
fi

bash "$source_dir/cmake/install_dependencies.sh"
# An existing build tree keeps its tests; a new one does without, and without GoogleTest.
tests=()
[ -f "$build_dir/CMakeCache.txt" ] || tests=(-DPCL_MSF_BUILD_TESTS=OFF)
configure -DPCL_MSF_BUILD_EXAMPLES=ON "${tests[@]}"
build pcl_msf_synthesize pcl_msf_scene_flow pcl_msf_flow_error pcl_msf_report
# Renders need VTK; without it everything else is there.
renders=""
if cmake --build "$build_dir" --target help | grep pcl_msf_render >/dev/null; then
  renders=yes
  build pcl_msf_render
fi

mkdir -p "$demo_dir"
# The demo's own files, beside those of the tools: an earlier demo's go, unless somebody
# has changed them, and nobody else's file is replaced.
list="$demo_dir/.pcl_msf_demo"
refuse () { echo "demo: $1; move it, or set PCL_MSF_DEMO_DIR" >&2; exit 1; }
forget_earlier () {
  local line file
  [ -f "$list" ] || return 0
  while read -r line; do
    file="$demo_dir/${line#*  }"
    for image in "${images[@]}"; do
      if [ "$file" -ef "$image" ]; then refuse "$image would be replaced by this demo's"; fi
    done
  done < "$list"
  while read -r line; do
    file="$demo_dir/${line#*  }"
    [ "$(sha256sum 2>/dev/null < "$file")" != "${line%%  *}  -" ] || rm "$file"
  done < "$list"
  rm "$list"
}
own_file () { # a name in the demo's folder
  [ ! -e "$demo_dir/$1" ] || refuse "$demo_dir/$1 is not of an earlier demo"
}
note () { (cd "$demo_dir" && sha256sum "$1" >> "$list"); }
copy_of () { # the name that the demo's copy of an image gets
  local name="${2##*/}"
  echo "$1.${name##*.}"
}
truth=""
if [ $# -eq 0 ]; then
  truth="$demo_dir/sequence/gt"
  "$build_dir/examples/pcl_msf_synthesize" "$demo_dir/sequence" \
    --scene articulated --frames 2 --depth png
  sequence="$demo_dir/sequence"
  images=("$sequence"/color_0.png "$sequence"/depth_0.png
          "$sequence"/color_1.png "$sequence"/depth_1.png)
  read_camera "$sequence/camera.txt"
fi

forget_earlier
input0="$(copy_of input_0 "${images[0]}")"
input1="$(copy_of input_1 "${images[2]}")"
for name in "$input0" "$input1" error_0_1.png; do own_file "$name"; done

"$build_dir/examples/pcl_msf_scene_flow" \
  --color "${images[0]}" --depth "${images[1]}" \
  --color "${images[2]}" --depth "${images[3]}" \
  --camera "$camera" --depth-scale "$depth_scale" --output "$demo_dir"
cp "${images[0]}" "$demo_dir/$input0" && note "$input0"
cp "${images[2]}" "$demo_dir/$input1" && note "$input1"

if [ -n "$truth" ]; then
  echo
  echo "End-point error against the truth:"
  "$build_dir/examples/pcl_msf_flow_error" "$demo_dir/flow_0_1.flo" \
    "$truth/flow_0_1.flo" "$truth/visible_0_1.png" "$demo_dir/error_0_1.png"
  note error_0_1.png
fi
if [ -z "$renders" ]; then
  echo "No renders: VTK was not there when the build was configured (libvtk9-dev)"
elif [ -n "$truth" ]; then
  "$build_dir/examples/pcl_msf_render" "$demo_dir" --sequence "$sequence" --quiet \
    --kind before_tints --kind after_tints --output "$demo_dir"
else # the current frame is not at hand in the layout that a sequence has
  "$build_dir/examples/pcl_msf_render" "$demo_dir" --quiet \
    --kind warped --kind arrows --output "$demo_dir"
fi
"$build_dir/examples/pcl_msf_report" "$demo_dir" --title "pcl_msf demo" \
  --output "$demo_dir/index.html" >/dev/null
echo
echo "Pictures in $demo_dir:"
for picture in input_0:"the reference image" input_1:"the current image" \
  segments_0:"segments of the reference" flow_0_1:"optical flow, Middlebury colours" \
  overlay_0_1:"the warped reference over the current image" \
  before_tints:"both clouds before alignment" after_tints:"both clouds after warping" \
  warped:"the warped cloud" arrows:"displacement" \
  overview_0:"all on one sheet" index:"all of it as a page for a browser"
do
  for file in "$demo_dir/${picture%%:*}".*; do
    case "$file" in *.flo | *'*') ;; *) printf '  %-18s %s\n' "${file##*/}" "${picture#*:}" ;; esac
  done
done
