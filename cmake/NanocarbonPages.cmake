# SPDX-License-Identifier: GPL-2.0-or-later
# The manual pages and the completion of bash, made from the page of options; left out where there is no Python 3.
find_package(Python3 COMPONENTS Interpreter)
if(NOT Python3_FOUND OR NOT NANOCARBON_PROGRAM)
  message(STATUS "No manual pages and no completion of the shell: they need Python 3")
  return()
endif()

set(NANOCARBON_PAGES ${PROJECT_BINARY_DIR}/pages)
set(maker ${PROJECT_SOURCE_DIR}/preprocessor/doc/make_pages.py)
set(options_page ${PROJECT_SOURCE_DIR}/preprocessor/doc/options.md)
add_custom_command(
  OUTPUT ${NANOCARBON_PAGES}/nanocarbon.bash
  COMMAND ${Python3_EXECUTABLE} ${maker} ${options_page} ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_VERSION} ${NANOCARBON_PAGES}
  DEPENDS ${maker} ${options_page} ${PROJECT_SOURCE_DIR}/README.md VERBATIM)
add_custom_target(pages ALL DEPENDS ${NANOCARBON_PAGES}/nanocarbon.bash)
set(host_page ${PROJECT_SOURCE_DIR}/lammps-plugin/doc/lmp-nanocarbon.1)
set(packed_host_page ${PROJECT_BINARY_DIR}/lmp-nanocarbon.1.gz)
install(DIRECTORY ${NANOCARBON_PAGES}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)
install(FILES ${NANOCARBON_PAGES}/nanocarbon.bash RENAME nanocarbon
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
if(TARGET lmp-nanocarbon)
  add_custom_command(OUTPUT ${packed_host_page}
    COMMAND ${Python3_EXECUTABLE} -c
            "import gzip, sys; gzip.GzipFile(sys.argv[2], 'wb', 9, mtime=0).write(open(sys.argv[1], 'rb').read())"
            ${host_page} ${packed_host_page}
    DEPENDS ${host_page} VERBATIM)
  add_custom_target(host_page ALL DEPENDS ${packed_host_page})
  install(FILES ${packed_host_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
endif()
