# SPDX-License-Identifier: BSD-3-Clause
# Target docs: the public headers' documentation as pages, docs/html in the build tree.
# A warning of Doxygen's is an error.
find_package (Doxygen QUIET)
if (NOT DOXYGEN_FOUND)
  message (STATUS "pcl_msf has no target docs: Doxygen is missing (Debian: doxygen)")
  return ()
endif ()

set (DOXYGEN_OUTPUT_DIRECTORY docs)
set (DOXYGEN_USE_MDFILE_AS_MAINPAGE README.md)
set (DOXYGEN_EXCLUDE_PATTERNS */impl/*)
set (DOXYGEN_EXCLUDE_SYMBOLS pcl_msf::detail pcl_msf::detail::*)
set (DOXYGEN_FILE_PATTERNS *.h)
set (DOXYGEN_STRIP_FROM_PATH "${PROJECT_SOURCE_DIR}/include")
set (DOXYGEN_JAVADOC_AUTOBRIEF YES)
set (DOXYGEN_MACRO_EXPANSION YES)
set (DOXYGEN_PREDEFINED PCL_MSF_EXPORT=)
set (DOXYGEN_EXTRACT_LOCAL_CLASSES NO)
set (DOXYGEN_WARN_IF_UNDOCUMENTED NO)
set (DOXYGEN_WARN_IF_INCOMPLETE_DOC NO) # what a type says need not be said
set (DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
set (DOXYGEN_QUIET YES)
set (DOXYGEN_GENERATE_LATEX NO)
set (DOXYGEN_HAVE_DOT NO)
doxygen_add_docs (docs
  include/pcl_msf README.md ARCHITECTURE.md BENCHMARK.md CHANGELOG.md DECISIONS.md
  WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
  COMMENT "Documentation in ${PROJECT_BINARY_DIR}/docs/html")
