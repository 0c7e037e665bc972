#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds with the address and undefined-behaviour sanitizers and runs the tests.
# Environment: PCL_MSF_BUILD_DIR, build directory (default: build-sanitize).
set -euo pipefail
export PCL_MSF_BUILD_DIR="${PCL_MSF_BUILD_DIR:-$(dirname "${BASH_SOURCE[0]}")/../build-sanitize}"
# OpenCV, PCL and their libraries keep static objects until the end: not our leaks.
export ASAN_OPTIONS="detect_leaks=0:${ASAN_OPTIONS:-}"
export UBSAN_OPTIONS="halt_on_error=1:print_stacktrace=1:${UBSAN_OPTIONS:-}"
exec bash "$(dirname "${BASH_SOURCE[0]}")/test.sh" -DPCL_MSF_SANITIZE=address,undefined \
  -DPCL_MSF_PACKAGE_TESTS=OFF "$@"
