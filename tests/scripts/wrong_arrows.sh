#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# cmake/check_rooms.sh finds each kind of arrow that points the wrong way.
set -euo pipefail
check="$(dirname "${BASH_SOURCE[0]}")/../../cmake/check_rooms.sh"
tree="$(mktemp -d)"
trap 'rm -rf "$tree"' EXIT
failed=0

try () { # 0|1 FILE LINE: what the check says of a tree with this file
  rm -rf "${tree:?}"/*
  mkdir -p "$tree"/{include,src,examples,tests} "$tree/$(dirname "$2")"
  printf '%s\n' "$3" > "$tree/$2"
  local status=0
  bash "$check" "$tree" 2>/dev/null || status=$?
  [ "$status" -eq "$1" ] || { echo "$2: $3: exit status $status, not $1"; failed=1; }
}

try 0 src/core/solve/a.h '#include "core/energy/b.h"'
try 1 src/core/energy/a.h '#include "core/solve/b.h"'
try 1 src/core/start/a.h '#include "core/bodies/b.h"'
try 1 src/core/nowhere/a.h '#include "core/base/b.h"'
try 0 src/io/page/a.cpp '#include "io/figures/b.h"'
try 1 src/io/formats/a.cpp '#include "io/page/b.h"'
try 1 src/io/figures/a.cpp '#include "io/results/b.h"'
try 0 src/io/page/a.cpp '#include "core/base/b.h"'
try 1 src/io/page/a.cpp '#include "core/frame/b.h"'
try 1 src/core/base/a.cpp '#include "io/base/b.h"'
try 1 src/core/base/a.cpp '#include <pcl_msf/io/b.h>'
try 1 src/synthetic/a.cpp '#include <pcl_msf/evaluation/b.h>'
try 0 src/synthetic/a.cpp '#include <pcl_msf/io/b.h>'
try 1 include/pcl_msf/a.h '#include <pcl_msf/io/b.h>'
try 0 examples/tools/view/a.cpp '#include "common/b.h"'
try 1 examples/tools/view/a.cpp '#include "render/b.h"'
try 1 examples/tools/view/a.cpp '#include "core/solve/b.h"'
try 1 examples/tools/view/CMakeLists.txt '  SOURCES ../render/inputs.cpp'
try 1 tests/tools/CMakeLists.txt '    ${PROJECT_SOURCE_DIR}/examples/tools/view/a.cpp'
try 0 tests/core/data/a.cpp '#include "core/data/b.h"'
try 1 tests/io/a.cpp '#include "core/data/b.h"'
exit $failed
