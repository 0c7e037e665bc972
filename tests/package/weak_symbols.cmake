# SPDX-License-Identifier: BSD-3-Clause
# Functions of templates that the library's objects hold are shared with the program that
# they are linked into: the linker keeps one copy of a name. Those that depend on Eigen's
# alignment or allocator would be wrong for one of the two when it is compiled with
# -march=native. Only the instances of the registration classes may have such (a program
# with other flags doesn't take those).
# LIBRARIES, NM
cmake_minimum_required (VERSION 3.18)
set (found "")
foreach (library IN LISTS LIBRARIES)
  execute_process (COMMAND "${NM}" -C "${library}"
    OUTPUT_VARIABLE symbols ERROR_QUIET RESULT_VARIABLE failed)
  if (failed)
    message (FATAL_ERROR "${NM} cannot read ${library}")
  endif ()
  string (REPLACE ";" "," symbols "${symbols}")
  string (REPLACE "[" "(" symbols "${symbols}") # brackets join the items of a list
  string (REPLACE "]" ")" symbols "${symbols}")
  string (REPLACE "\n" ";" symbols "${symbols}")
  set (object "")
  foreach (line IN LISTS symbols)
    if (line MATCHES "^([A-Za-z0-9_]+\\.cpp\\.o):$")
      set (object "${CMAKE_MATCH_1}")
    elseif (object MATCHES "^piecewise_rigid_(registration|tracker)\\.cpp\\.o$"
        OR NOT line MATCHES "^[0-9a-f]+ [WVu] (.*(Eigen::|aligned_allocator).*)$")
      continue ()
    endif ()
    set (name "${CMAKE_MATCH_1}")
    # Vector extensions change the alignment of what is a multiple of 32 bytes, and how
    # memory for any number of values is allocated.
    set (aligned FALSE)
    if (name MATCHES
        "aligned_(allocator|malloc|free)|Quaternion<double, 0>|Transform<[a-z]+, 3, [0-9]+, 0>")
      set (aligned TRUE)
    endif ()
    string (REGEX MATCHALL "(Matrix|Array)<(float|double|int), -?[0-9]+, -?[0-9]+, [0-9]+,"
      types "${name}")
    foreach (type IN LISTS types)
      string (REGEX MATCH "<([a-z]+), (-?[0-9]+), (-?[0-9]+), ([0-9]+)," type "${type}")
      set (bytes 4)
      if (CMAKE_MATCH_1 STREQUAL "double")
        set (bytes 8)
      endif ()
      math (EXPR rest "${bytes} * ${CMAKE_MATCH_2} * ${CMAKE_MATCH_3} % 32")
      math (EXPR dont_align "${CMAKE_MATCH_4} & 2")
      if (NOT dont_align AND (rest EQUAL 0 OR CMAKE_MATCH_2 LESS 0 OR CMAKE_MATCH_3 LESS 0))
        set (aligned TRUE)
      endif ()
    endforeach ()
    if (aligned)
      string (SUBSTRING "${name}" 0 200 name)
      string (APPEND found "  ${object}: ${name}\n")
    endif ()
  endforeach ()
endforeach ()
if (found)
  message (FATAL_ERROR "functions that depend on the alignment are shared:\n${found}")
endif ()
