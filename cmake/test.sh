#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds Release and runs the test suite; CTest's summary is
# the last output. Arguments go to CMake's configuration.
# Environment: PCL_MSF_BUILD_DIR, build directory (default: build).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/build_tree.sh"

bash "$source_dir/cmake/install_dependencies.sh" --tests
configure -DPCL_MSF_BUILD_TESTS=ON -DPCL_MSF_BUILD_EXAMPLES=ON \
  -DPCL_MSF_WARNINGS_AS_ERRORS=OFF "$@"
build
cd "$build_dir"
ctest --output-on-failure -j2
