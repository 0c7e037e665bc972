#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Includes point one way. The rooms of src/core stand in the order of the method; a file
# includes from its own room and from those before it, start, bodies and result not from
# each other. io knows the core, the other components know io and the core, and no
# component but the core's own files includes above it. Exits non-zero and lists the
# arrows that point the wrong way.
# usage: bash cmake/check_rooms.sh [SOURCE_TREE]
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}/src"

rooms=(base frame motion surface segments window data energy points start bodies result solve pcl)
declare -A place
for i in "${!rooms[@]}"; do place[${rooms[i]}]=$i; done
place[start]=${place[result]} # side by side: the same place, but not the same room
place[bodies]=${place[result]}

wrong=()
while IFS=: read -r file include; do
  from="${file#core/}"; from="${from%%/*}"
  to="${include#*\"core/}"; to="${to%%/*}"
  if [ -z "${place[$from]:-}" ] || [ -z "${place[$to]:-}" ]; then
    wrong+=("$file: $include (no such room)")
  elif [ "$from" != "$to" ] && [ "${place[$to]}" -ge "${place[$from]}" ]; then
    wrong+=("$file: $include")
  fi
done < <(grep -rHo --include='*.h' --include='*.cpp' '#include "core/[^"]*"' core)
while IFS= read -r line; do
  wrong+=("$line")
done < <(grep -rHoE '#include "(io|synthetic|evaluation|visualization)/[^"]*"' core
         grep -rHoE '#include "(synthetic|evaluation|visualization)/[^"]*"' io)
[ ${#wrong[@]} -eq 0 ] && exit 0
printf 'includes the wrong way: %s\n' "${wrong[@]}" >&2
exit 1
