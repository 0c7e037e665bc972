#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds for arm64 with a cross compiler, and runs tests of the core under qemu-user: of
# frames, the energy and the solve. On Debian, with g++-aarch64-linux-gnu and
# qemu-user-static; fetches 600 MB of arm64 packages and unpacks them (3 GB) without
# installing any.
# usage: bash cmake/test_arm64.sh [TEST PROGRAM ...]
# Environment: PCL_MSF_BUILD_DIR, build directory (default: build-arm64), which keeps the
# packages, too.
set -euo pipefail
source_dir="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
build="$(mkdir -p "${PCL_MSF_BUILD_DIR:-$source_dir/build-arm64}" &&
         cd "${PCL_MSF_BUILD_DIR:-$source_dir/build-arm64}" && pwd)"
programs=("$@")
[ $# -gt 0 ] || programs=(test_core_frames test_core_energy test_core_solve)
packages=(libstdc++-12-dev libeigen3-dev libpcl-dev libceres-dev libopencv-dev
          libopencv-contrib-dev libvtk9-dev libblas-dev liblapack-dev libcli11-dev
          nlohmann-json3-dev libgtest-dev libgmock-dev)

for tool in aarch64-linux-gnu-g++ qemu-aarch64-static apt-get dpkg; do
  if ! command -v "$tool" >/dev/null; then
    echo "test_arm64: no $tool here (Debian: apt-get install g++-aarch64-linux-gnu" \
         "qemu-user-static)" >&2
    exit 1
  fi
done

fetch () { # the packages' files, by an apt that knows of no installed ones
  local apt="$build/apt"
  mkdir -p "$apt"/{lists/partial,cache/archives/partial,parts}
  : >"$apt/status"
  local options=(-q -o APT::Architecture=arm64 -o APT::Architectures::=arm64
    -o "Dir::State=$apt" -o "Dir::State::lists=$apt/lists" -o "Dir::Cache=$apt/cache"
    -o "Dir::State::status=$apt/status" -o "Dir::Etc::parts=$apt/parts"
    -o Debug::NoLocking=1)
  apt-get "${options[@]}" update
  apt-get "${options[@]}" -y --no-install-recommends --download-only install \
    "${packages[@]}"
}

unpack () { # absolute paths in links and CMake files lead into the folder then
  local root="$1" file
  rm -rf "$root"
  mkdir -p "$root"
  for file in "$build"/apt/cache/archives/*.deb; do
    dpkg -x "$file" "$root"
  done
  find "$root" -type l -lname '/*' | while read -r file; do
    ln -sfn "$root$(readlink "$file")" "$file"
  done
  { grep -rlE '[";]/usr/(lib|include)' --include='*.cmake' "$root/usr" || true; } |
    xargs -r sed -i -E "s#([\";])/usr/(lib|include)#\1$root/usr/\2#g"
  for file in "$root"/usr/lib/aarch64-linux-gnu/{blas,lapack}/*.so*; do
    ln -sf "$file" "$root/usr/lib/aarch64-linux-gnu/" # as update-alternatives does
  done
  touch "$root/complete"
}

root="$build/root"
if [ ! -e "$root/complete" ]; then
  fetch
  unpack "$root"
fi
cmake -S "$source_dir" -B "$build" -DPCL_MSF_ARM64_ROOT="$root" \
  -DCMAKE_TOOLCHAIN_FILE="$source_dir/cmake/PclMsfArm64.cmake" \
  -DCMAKE_BUILD_TYPE=Release -DPCL_MSF_BUILD_TESTS=ON -DPCL_MSF_BUILD_EXAMPLES=ON \
  -DPCL_MSF_BUILD_VISUALIZATION=OFF -DPCL_MSF_PACKAGE_TESTS=OFF
cmake --build "$build" -j "$(nproc)" --target "${programs[@]}"
for program in "${programs[@]}"; do
  qemu-aarch64-static -L "$root" "$(find "$build" -name "$program" -type f -perm -u+x)"
done
