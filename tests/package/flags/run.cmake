# SPDX-License-Identifier: BSD-3-Clause
# Builds targets of this folder with a user's flags and runs what can be run.
# SOURCE, BUILD, GENERATOR, PREFIX, COMPILER, LAUNCHER, CLOUD, TARGETS
cmake_minimum_required (VERSION 3.18)
file (REMOVE_RECURSE "${BUILD}")

function (run description)
  execute_process (COMMAND ${ARGN}
    OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    message (FATAL_ERROR "${description}: ${result}\n${output}")
  endif ()
endfunction ()

run ("configuration" ${CMAKE_COMMAND} -S "${SOURCE}" -B "${BUILD}" -G "${GENERATOR}"
  -DCMAKE_PREFIX_PATH=${PREFIX} -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
  -DARCHITECTURE=-march=native)
foreach (target IN LISTS TARGETS)
  if (NOT target STREQUAL "fast_math")
    run ("${target}: build" ${CMAKE_COMMAND} --build "${BUILD}" --target ${target})
  endif ()
  if (target MATCHES "stock|own")
    run ("${target}" "${BUILD}/${target}" "${CLOUD}")
  endif ()
endforeach ()
if ("fast_math" IN_LIST TARGETS)
  execute_process (COMMAND ${CMAKE_COMMAND} --build "${BUILD}" --target fast_math
    OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
  if (result EQUAL 0 OR NOT output MATCHES "add -fno-finite-math-only")
    message (FATAL_ERROR "-ffast-math is not refused with a remedy:\n${output}")
  endif ()
endif ()
