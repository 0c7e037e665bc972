#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# clang-format on all tracked C++ files and clang-tidy on the compiled ones; exits
# non-zero when either has something to say.
# usage: bash cmake/check_style.sh [--format-only]
# Environment: PCL_MSF_BUILD_DIR, build directory (default: build).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/build_tree.sh"
cd "$source_dir"

for tool in clang-format clang-tidy; do
  if ! command -v "$tool" >/dev/null; then
    echo "check_style: $tool is missing (Debian: $tool)" >&2
    exit 1
  fi
done

mapfile -t files < <(git ls-files '*.h' '*.hpp' '*.cpp')
clang-format --dry-run -Werror "${files[@]}"
echo "clang-format: ${#files[@]} files are as .clang-format has it"
[ "${1:-}" = --format-only ] && exit 0

# CMake leaves the standard to the compiler where it is the default; clang-tidy's is older.
cmake -S . -B "$build_dir" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
mapfile -t sources < <(git ls-files '*.cpp' | while read -r file; do
  grep -q "\"file\": \".*/$file\"" "$build_dir/compile_commands.json" && echo "$file" || true
done)
printf '%s\n' "${sources[@]}" |
  xargs -P "$jobs" -n 1 clang-tidy --quiet -p "$build_dir" --extra-arg=-std=c++17 \
    --header-filter='.*/(include/pcl_msf|src)/.*'
echo "clang-tidy: ${#sources[@]} files"
