# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Installs the build, uses it from a project of its own, and runs the installed program on an installed sample.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)

set(prefix ${FOLDER}/prefix)
file(REMOVE_RECURSE ${prefix} ${FOLDER}/package)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/*)
foreach(header ${headers})
  if(NOT header MATCHES "^meniscus/(c/)?[a-z_]+\\.h$")
    message(FATAL_ERROR "${header} is installed, but is no public header")
  endif()
endforeach()

build_and_run_consumer(${FOLDER}/package -DCMAKE_PREFIX_PATH=${prefix})

# A sample that the source tree does not have can only come from the prefix.
file(COPY_FILE ${prefix}/share/meniscus/scenes/hydrostatic.json ${prefix}/share/meniscus/scenes/installed.json)
run(${prefix}/bin/meniscus check installed)
file(REMOVE_RECURSE ${prefix} ${FOLDER}/package)
