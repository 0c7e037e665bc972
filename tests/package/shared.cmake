# SPDX-License-Identifier: BSD-3-Clause
# The libraries as shared ones that hide what no header exports: they and the tools link
# with each other, a user's program builds against them, and nothing private is shown.
# SOURCE, BUILD, CONSUMER, GENERATOR, COMPILER, LAUNCHER, NM
cmake_minimum_required (VERSION 3.18)

function (run)
  execute_process (COMMAND ${ARGV}
    RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (failed)
    string (REPLACE ";" " " command "${ARGV}")
    message (FATAL_ERROR "${command}:\n${output}")
  endif ()
endfunction ()

set (common -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${COMPILER}
  -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
run (${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD}/libraries ${common}
  -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DBUILD_SHARED_LIBS=ON
  -DPCL_MSF_BUILD_TESTS=OFF)
run (${CMAKE_COMMAND} --build ${BUILD}/libraries)
run (${CMAKE_COMMAND} --install ${BUILD}/libraries --prefix ${BUILD}/prefix)
run (${CMAKE_COMMAND} -S ${CONSUMER} -B ${BUILD}/consumer ${common}
  -DCMAKE_PREFIX_PATH=${BUILD}/prefix -DCOMPONENTS=io -DSOURCE=use_io.cpp)
run (${CMAKE_COMMAND} --build ${BUILD}/consumer)
run (${BUILD}/consumer/consumer)

file (GLOB_RECURSE libraries "${BUILD}/prefix/libpcl_msf*.so")
if (NOT libraries)
  message (FATAL_ERROR "no shared libraries were installed")
endif ()
foreach (library IN LISTS libraries)
  execute_process (COMMAND ${NM} -DC --defined-only ${library} OUTPUT_VARIABLE symbols)
  # Their own functions; copies of the standard library's over private types do no harm.
  string (REGEX MATCH "[A-Za-z] pcl_msf::(DataTerm|Energy|WindowSolve|io::PcdHeader|io::CloudFields)::[^\n]*"
    private "${symbols}")
  if (private)
    message (FATAL_ERROR "${library} shows ${private}")
  endif ()
endforeach ()
