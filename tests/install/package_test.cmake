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

# The first programs. With sanitizers the C library needs theirs in the program, which is no user's case.
if(C_LIBRARY AND NOT SANITIZE)
  set(first ${CMAKE_CURRENT_LIST_DIR}/first_programs)
  file(REMOVE_RECURSE ${FOLDER}/first_programs)
  run(${CMAKE_COMMAND} -S ${first} -B ${FOLDER}/first_programs -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCMAKE_PREFIX_PATH=${prefix}
    -DHELLO=${CMAKE_CURRENT_LIST_DIR}/../../samples/hello)
  run(${CMAKE_COMMAND} --build ${FOLDER}/first_programs --parallel 2)
  run(${FOLDER}/first_programs/hello_c)
  run(${FOLDER}/first_programs/hello_cpp)
  run(${FOLDER}/first_programs/read_scene ${prefix}/share/meniscus/scenes/ropes.json)
  file(REMOVE_RECURSE ${FOLDER}/first_programs)
endif()

# A sample that the source tree does not have can only come from the prefix.
file(COPY_FILE ${prefix}/share/meniscus/scenes/hydrostatic.json ${prefix}/share/meniscus/scenes/installed.json)
run(${prefix}/bin/meniscus check installed)
file(REMOVE_RECURSE ${prefix} ${FOLDER}/package)
