# SPDX-License-Identifier: BSD-3-Clause
# Toolchain: Debian's cross compiler for arm64, libraries from unpacked packages, programs
# run by qemu-user; see test_arm64.sh, which makes the folder PCL_MSF_ARM64_ROOT.
set (CMAKE_SYSTEM_NAME Linux)
set (CMAKE_SYSTEM_PROCESSOR aarch64)
set (CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set (CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set (CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
list (APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES PCL_MSF_ARM64_ROOT)

set (CMAKE_SYSROOT ${PCL_MSF_ARM64_ROOT})
set (CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set (CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set (CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set (CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set (CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L ${PCL_MSF_ARM64_ROOT})

set (libraries ${PCL_MSF_ARM64_ROOT}/usr/lib/aarch64-linux-gnu)
set (CMAKE_EXE_LINKER_FLAGS_INIT
  "-Wl,-rpath-link,${libraries}:${libraries}/blas:${libraries}/lapack:${libraries}/openmpi/lib")
