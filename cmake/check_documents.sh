#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The documents speak of what there is. Names in ARCHITECTURE.md that stand in `backticks`
# must exist: types as such, others as a path, a file's name without its ending or a word
# of the sources; its map has every folder of the sources; links from one file to another
# lead to one. Exits non-zero and lists what does not hold.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folders=(include src examples tests cmake)

exists () {
  [ -e "$1" ] || [ -e "include/pcl_msf/$1" ] || [ -e "cmake/$1" ] && return
  if [[ "$1" =~ ^[A-Z][a-z] && "$1" != *.* ]]; then # a type
    grep -rqE --include='*.h' "^ *(class|struct|enum class|using) (PCL_MSF_EXPORT )?$1\b" "${folders[@]}"
  else
    [ -n "$(find "${folders[@]}" -name "${1##*/}.*" -print -quit)" ] ||
      grep -rqwF --include='*.h' --include='*.hpp' --include='*.cpp' --include='CMakeLists.txt' \
        -- "${1#pcl_msf::}" "${folders[@]}"
  fi
}

wrong=()
while read -r name; do
  name="${name#.../}"      # "include/pcl_msf/io, .../synthetic"
  name="${name%%<*}"       # "Class<PointT>"
  name="${name%"()"}"
  name="${name%% *}"
  exists "$name" || wrong+=("ARCHITECTURE.md names what does not exist: $name")
done < <(tr '\n' ' ' < ARCHITECTURE.md | grep -o '`[^`]*`' | tr -d '`' | sort -u)

map="$(sed -n '/^## Map/,/^Layers/p' ARCHITECTURE.md)"
for folder in src/* src/core/* src/io/* examples/* examples/tools/* tests/*; do
  [ -d "$folder" ] || continue
  name="${folder##*/}"
  grep -qE "\`([a-z/._]*/)?$name\`" <<< "$map" ||
    wrong+=("ARCHITECTURE.md: the map lacks $folder")
done

for document in *.md; do
  while read -r link; do
    [ -e "$link" ] || wrong+=("$document: a link to $link, which does not exist")
  done < <(grep -oE '\]\([^)]+\)' "$document" | sed -E 's/^\]\(([^)#]*).*/\1/' |
    grep -vE '^(https?:.*)?$' || true)
done
[ ${#wrong[@]} -eq 0 ] && exit 0
printf '%s\n' "${wrong[@]}" >&2
exit 1
