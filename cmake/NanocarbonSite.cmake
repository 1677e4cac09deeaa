# SPDX-License-Identifier: GPL-2.0-or-later
# cmake --build build/release --target site: all pages, the library's reference and the gallery as one site, in
# build/release/site/index.html. Nothing is downloaded.
if(NOT NANOCARBON_PROGRAM)
  return()
endif()
foreach(python /usr/bin/python3 python3)  # Debian's modules belong to /usr/bin/python3
  execute_process(COMMAND ${python} -c "import markdown_it, docutils" RESULT_VARIABLE without OUTPUT_QUIET ERROR_QUIET)
  if(without EQUAL 0)
    set(NANOCARBON_SITE_PYTHON ${python})
    break()
  endif()
endforeach()
if(NOT NANOCARBON_SITE_PYTHON)
  message(STATUS "No target site: it needs python3-markdown-it and python3-docutils")
  return()
endif()

set(gallery ${PROJECT_SOURCE_DIR}/examples/gallery/make.py)
set(pictures ${PROJECT_SOURCE_DIR}/examples/pictures/draw.py ${PROJECT_SOURCE_DIR}/examples/pictures/picture.in)
set(maker ${PROJECT_SOURCE_DIR}/preprocessor/doc/site/make_site.py)
set(site_parts)
if(NANOCARBON_THREE_JS AND NANOCARBON_THREE_LICENCE)  # pages of molecules need them
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/gallery/gallery.json
    COMMAND ${CMAKE_COMMAND} -E env NANOCARBON=$<TARGET_FILE:nanocarbon> ${NANOCARBON_SITE_PYTHON} -B ${gallery} ${PROJECT_BINARY_DIR}/gallery
    DEPENDS nanocarbon ${gallery} ${pictures} COMMENT "Making the gallery" VERBATIM)
  set(site_gallery ${PROJECT_BINARY_DIR}/gallery/gallery.json)
  list(APPEND site_parts --gallery ${PROJECT_BINARY_DIR}/gallery)
endif()
if(TARGET doxygen)
  list(APPEND site_parts --reference ${PROJECT_BINARY_DIR}/reference/html)
endif()
add_custom_target(site
  COMMAND ${NANOCARBON_SITE_PYTHON} -B ${maker} ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/site ${site_parts}
  DEPENDS ${site_gallery} COMMENT "Making the site: ${PROJECT_BINARY_DIR}/site/index.html" VERBATIM)
if(TARGET doxygen)
  add_dependencies(site doxygen)
endif()
