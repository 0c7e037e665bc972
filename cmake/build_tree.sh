# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the other scripts: where the source and build trees are, and how to build.
# PCL_MSF_BUILD_DIR: build directory, default build in the source tree.

source_dir="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
build_dir="${PCL_MSF_BUILD_DIR:-$source_dir/build}"
jobs="$(nproc 2>/dev/null || echo 1)"

# configure [cmake options...]: Release; what CMake says is shown only when it fails.
configure () {
  local options=(-DCMAKE_BUILD_TYPE=Release "$@")
  if [ ! -f "$build_dir/CMakeCache.txt" ] && command -v ninja >/dev/null; then
    options+=(-G Ninja)
  fi
  if command -v ccache >/dev/null; then
    options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  echo "Configuring in $build_dir"
  local log
  log="$(mktemp)"
  cmake -S "$source_dir" -B "$build_dir" "${options[@]}" >"$log" 2>&1 ||
    { cat "$log" >&2; rm -f "$log"; return 1; }
  rm -f "$log"
}

# build [targets...]: these targets, or all.
build () {
  cmake --build "$build_dir" --parallel "$jobs" ${1:+--target "$@"}
}
