#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the pictures of README.md in examples/pictures from a generated sequence, each
# below 250 kB. Needs VTK, and ImageMagick to make them small.
# Environment: PCL_MSF_BUILD_DIR, build directory (default: build).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/build_tree.sh"

if ! command -v convert >/dev/null; then
  echo "pictures: ImageMagick is missing (Debian: imagemagick)" >&2
  exit 1
fi
configure -DPCL_MSF_BUILD_EXAMPLES=ON -DPCL_MSF_BUILD_VISUALIZATION=ON
build pcl_msf_synthesize pcl_msf_scene_flow pcl_msf_render \
  10_behind_pcl_filters 11_supervoxels 12_grown_regions 13_map_of_many_clouds \
  14_planes_of_a_camera 15_things_apart
bin="$build_dir/examples"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

"$bin/pcl_msf_synthesize" "$work/sequence" --scene articulated --motion large --frames 2 --depth png
read -r fx fy cx cy _ _ scale < "$work/sequence/camera.txt"
"$bin/pcl_msf_scene_flow" --quiet \
  --color "$work/sequence/color_0.png" --depth "$work/sequence/depth_0.png" \
  --color "$work/sequence/color_1.png" --depth "$work/sequence/depth_1.png" \
  --camera "$fx,$fy,$cx,$cy" --depth-scale "$scale" --output "$work/result"
render () {
  "$bin/pcl_msf_render" "$work/result" --sequence "$work/sequence" --quiet \
    --size 480x360 --supersampling 4 --output "$work" "$@"
}
render --kind before_tints --kind after_tints
render --kind arrows --kind motions --view orbit --azimuth 12 --elevation 12 --zoom 1.5

small () { # one picture, few enough colours to be small
  convert "$1" "${@:3}" -strip +dither -colors 240 "PNG8:$source_dir/examples/pictures/$2"
}
small "$work/result/overview_0.png" overview.png -resize 900x
for picture in before_tints after_tints arrows motions; do
  small "$work/$picture.png" "$picture.png"
done
# A failure: a sheet that bends and moves by 80 pixels; its ends are lost.
"$bin/pcl_msf_synthesize" "$work/fast" --scene bending --motion-pixels 80 --frames 2 \
  --width 320 --height 240 --depth png --seed 4
"$bin/pcl_msf_scene_flow" "$work/fast" --window 2 --quiet --output "$work/lost"
convert "$work/lost/overlay_0_1.png" "$work/lost/residual_0_1.png" "$work/lost/motions_0.png" \
  -background white -bordercolor white -border 4x0 +append "$work/lost.png"
small "$work/lost.png" failure.png -resize 790x
(cd "$work" && for example in "$bin"/1[0-5]_*; do "$example"; done)
machinery=(voxel_grid statistical_outlier_removal supervoxels grown_regions planes clusters map)
(cd "$work" && convert "${machinery[@]/%/.png}" -append machinery.png)
small "$work/machinery.png" pcl_machinery.png -resize 900x
for picture in "$source_dir"/examples/pictures/*.png; do
  printf '%7d bytes  %s\n' "$(stat -c %s "$picture")" "${picture#"$source_dir"/}"
done
