# SPDX-License-Identifier: GPL-2.0-or-later
# cmake --build build/release --target doxygen: the library's reference, from the comments of its headers, in
# build/release/reference/html. A comment that says something wrong of its function ends it with an error.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
  return()
endif()

set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/reference)
set(DOXYGEN_FILE_PATTERNS *.h)
set(DOXYGEN_EXCLUDE_PATTERNS */compat/stand-in/*)
set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR}/preprocessor ${PROJECT_SOURCE_DIR})
set(DOXYGEN_STRIP_FROM_INC_PATH ${PROJECT_SOURCE_DIR}/preprocessor)
# A comment says what the declaration does not: parameters and members that speak for themselves have none.
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_WARN_IF_UNDOCUMENTED NO)
set(DOXYGEN_WARN_NO_PARAMDOC NO)
set(DOXYGEN_WARN_IF_INCOMPLETE_DOC NO)
set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_MACRO_EXPANSION YES)
set(DOXYGEN_GENERATE_LATEX NO)
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_USE_MATHJAX NO)
doxygen_add_docs(doxygen preprocessor/nanocarbon WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                 COMMENT "The library's reference: ${PROJECT_BINARY_DIR}/reference/html/index.html")
# Doxygen leaves the pages of headers that are gone.
add_custom_target(doxygen_clear COMMAND ${CMAKE_COMMAND} -E rm -rf ${DOXYGEN_OUTPUT_DIRECTORY}/html VERBATIM)
add_dependencies(doxygen doxygen_clear)
