# SPDX-License-Identifier: BSD-3-Clause
# Lists the suites of a GoogleTest PROGRAM for CTest in the file LIST: a process for each
# suite, since starting one takes longer than most tests. Output names the tests that
# fail. COSTS: some "suite=seconds"; CTest starts the dearest first. EMULATOR: what runs
# programs of another machine.
cmake_minimum_required (VERSION 3.18)
set (command ${EMULATOR} "${PROGRAM}")
execute_process (COMMAND ${command} --gtest_list_tests TIMEOUT 600 # a busy machine's
  OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE failed)
if (failed)
  message (FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${failed}\n${output}")
endif ()
string (REGEX MATCHALL "\n[A-Za-z0-9_/]+\\." suites "${output}")
list (TRANSFORM suites REPLACE "^\n(.*)\\.$" "\\1")
if (NOT suites)
  message (FATAL_ERROR "${PROGRAM} has no tests:\n${output}")
endif ()

list (JOIN command "\" \"" quoted)
set (text "")
foreach (suite IN LISTS suites)
  # Skipped: the last lines say so, and none that a test failed.
  string (APPEND text
    "add_test (\"${suite}\" \"${quoted}\" \"--gtest_filter=${suite}.*\")\n"
    "set_tests_properties (\"${suite}\" PROPERTIES WORKING_DIRECTORY \"${FOLDER}\"\n"
    "  SKIP_REGULAR_EXPRESSION [[\\[  SKIPPED \\] [^\n]*\n$]])\n")
endforeach ()
foreach (cost IN LISTS COSTS)
  string (REPLACE "=" ";" cost "${cost}")
  list (GET cost 0 suite)
  list (GET cost 1 seconds)
  if (NOT suite IN_LIST suites)
    message (FATAL_ERROR "${PROGRAM} has no suite ${suite}, of which COSTS speaks")
  endif ()
  string (APPEND text "set_tests_properties (\"${suite}\" PROPERTIES COST ${seconds})\n")
endforeach ()
file (WRITE "${LIST}" "${text}")
