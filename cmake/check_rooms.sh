#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Includes point one way. Exits non-zero and lists those that do not:
# - io knows the core; synthetic, evaluation and visualization know io and the core;
# - a library includes another's private headers only from its room `base`, which is there
#   for that; so do the tools;
# - rooms of core and io know those before them in the lists below; rooms between the same
#   commas stand side by side and do not know each other;
# - a tool knows examples/common and no other tool, nor does it compile another's files;
# - tests know the library or tools that they are named after, and tests/support;
#   benchmarks know the core and what the tools share.
# usage: bash cmake/check_rooms.sh [SOURCE_TREE]
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}"

core="base,frame,motion,surface,segments,window,data,energy,points,start bodies result,solve,pcl"
io="base,formats,figures results datasets,page"

includes () { # FILE:INCLUDED of all quoted includes and of our public headers
  grep -rHoE --include='*.h' --include='*.hpp' --include='*.cpp' \
    '^#include ("[^"]+"|<pcl_msf/[^>]+>)' include src examples tests |
    sed -E 's/:#include ["<]([^">]*)[">]/ \1/' || true
}

compiled () { # FILE SOURCE of sources that a CMakeLists.txt takes from elsewhere
  grep -rHoE --include=CMakeLists.txt '[^ ]*(\.\./|examples/|tests/)[^ ]*\.cpp' \
    examples tests | sed 's/:/ /' || true
}

wrong="$( { includes; compiled; } | awk -v core="$core" -v io="$io" '
  function list (lib, text,   steps, rooms, i, k) {
    split (text, steps, ",")
    for (i in steps) {
      split (steps[i], rooms, " ")
      for (k in rooms) place[lib "/" rooms[k]] = i + 0
    }
  }
  function level (lib) { return lib == "core" ? 0 : lib == "io" ? 1 : 2 }
  function isLibrary (name) {
    return name ~ /^(core|io|synthetic|evaluation|visualization)$/
  }
  function problem (why) { print $1 ": " $2 " (" why ")" }
  BEGIN { list("core", core); list("io", io) }
  {
    n = split ($1, from, "/"); m = split ($2, to, "/")
    tool = from[1] == "examples" && from[2] == "tools" ? from[3] : ""
  }
  $1 ~ /CMakeLists.txt$/ {
    if ($2 !~ /^\.\.\/common\//) problem("compiles a file of another folder")
    next
  }
  to[1] == "pcl_msf" { # a public header, included by one or by a library
    own = from[1] == "include" ? from[3] : from[2]
    if (from[1] != "include" && from[1] != "src") next
    if (!isLibrary(own)) own = "core"
    other = isLibrary(to[2]) ? to[2] : "core"
    if (own != other && level(other) >= level(own)) problem("the wrong way")
    next
  }
  from[1] == "src" {
    if (m == 1 || !isLibrary(to[1])) { problem("name the header from src"); next }
    if (from[2] != to[1]) {
      if (level(to[1]) >= level(from[2])) problem("the wrong way")
      else if (to[2] != "base") problem("a private header of another library")
      next
    }
    a = from[2] "/" from[3]; b = to[1] "/" to[2]
    if (from[2] != "core" && from[2] != "io") next
    if (!(a in place) || !(b in place)) problem("no such room")
    else if (a != b && place[b] >= place[a]) problem("the wrong way")
    next
  }
  from[1] == "examples" && m > 1 {
    if (isLibrary(to[1]) && to[2] != "base") problem("a private header of a library")
    else if (!isLibrary(to[1]) && to[1] != "common" && to[1] != tool)
      problem("not of this tool nor of examples/common")
    next
  }
  from[1] == "tests" && from[2] !~ /^(support|package)$/ {
    own = from[2] == "datasets" ? "io" : from[2] == "benchmarks" ? "core" : from[2]
    if (from[2] == "benchmarks" && (m == 1 || to[1] ~ /^(common|bench)$/)) next
    if (to[1] == "support" || to[1] == own || to[2] == "base") next
    if (own == "tools" && !isLibrary(to[1])) next
    problem("not of what these tests are named after")
  }')"
[ -z "$wrong" ] && exit 0
printf 'includes the wrong way:\n%s\n' "$wrong" >&2
exit 1
