#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Names in ARCHITECTURE.md that stand in `backticks` must exist: types as such, others as
# a path, a file's name without its ending or a word of the sources. Exits non-zero and
# lists those that do not.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folders=(include src examples tests cmake)

exists () {
  [ -e "$1" ] || [ -e "include/pcl_msf/$1" ] || [ -e "cmake/$1" ] && return
  if [[ "$1" =~ ^[A-Z][a-z] && "$1" != *.* ]]; then # a type
    grep -rqE --include='*.h' "^ *(class|struct|enum class|using) $1\b" "${folders[@]}"
  else
    [ -n "$(find "${folders[@]}" -name "${1##*/}.*" -print -quit)" ] ||
      grep -rqwF --include='*.h' --include='*.hpp' --include='*.cpp' --include='CMakeLists.txt' \
        -- "${1#pcl_msf::}" "${folders[@]}"
  fi
}

missing=()
while read -r name; do
  name="${name#.../}"      # "include/pcl_msf/io, .../synthetic"
  name="${name%%<*}"       # "Class<PointT>"
  name="${name%"()"}"
  name="${name%% *}"
  exists "$name" || missing+=("$name")
done < <(tr '\n' ' ' < ARCHITECTURE.md | grep -o '`[^`]*`' | tr -d '`' | sort -u)
[ ${#missing[@]} -eq 0 ] && exit 0
echo "ARCHITECTURE.md names what does not exist: ${missing[*]}" >&2
exit 1
