# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Installs the build, uses it from a project of its own and by pkg-config, and runs the installed program on an installed
# sample.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)

set(prefix ${FOLDER}/prefix)
file(REMOVE_RECURSE ${prefix} ${FOLDER}/package)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/*)
foreach(header ${headers})
  if(NOT header MATCHES "^meniscus/((c|device)/)?[a-z_]+\\.h$")
    message(FATAL_ERROR "${header} is installed, but is no public header")
  endif()
endforeach()

build_and_run_consumer(${FOLDER}/package -DCMAKE_PREFIX_PATH=${prefix} -DCOMPONENTS=Program)

# A constraint of one's own, without nvcc and, where it is found, with it. As with the first programs, not with sanitizers.
if(NOT SANITIZE)
  foreach(with_nvcc IN ITEMS OFF ON)
    run(${CMAKE_COMMAND} -S ${SOURCE}/samples/constraint -B ${FOLDER}/constraint -G ${GENERATOR}
      -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
      -DCMAKE_PREFIX_PATH=${prefix} -DWITH_NVCC=${with_nvcc})
    run(${CMAKE_COMMAND} --build ${FOLDER}/constraint)
    run(${FOLDER}/constraint/constraint cpu)
    file(REMOVE_RECURSE ${FOLDER}/constraint)
  endforeach()
endif()

# A component that is not there, and a package that is not: the message names both.
function(expect_refusal text)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${CONSUMER} -B ${FOLDER}/refused -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_PREFIX_PATH=${prefix} ${ARGN}
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE message)
  string(REGEX REPLACE "[ \n]+" " " message "${message}")
  string(FIND "${message}" "${text}" at)
  if(status EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "expected '${text}', but configuring said:\n${message}")
  endif()
  file(REMOVE_RECURSE ${FOLDER}/refused)
endfunction()
expect_refusal("Meniscus has no component Holograms" -DCOMPONENTS=Holograms)
expect_refusal("Meniscus needs assimp. On Debian and Ubuntu: apt-get install libassimp-dev zlib1g-dev"
  -DCMAKE_DISABLE_FIND_PACKAGE_assimp=ON)

if(PKG_CONFIG AND NOT SANITIZE)  # NOTFOUND is false
  file(GLOB_RECURSE pc ${prefix}/meniscus.pc)
  cmake_path(GET pc PARENT_PATH pc_folder)
  set(ENV{PKG_CONFIG_PATH} ${pc_folder}:$ENV{PKG_CONFIG_PATH})
  run(${PKG_CONFIG} --cflags --libs meniscus)
  separate_arguments(flags UNIX_COMMAND "${output}")
  cmake_path(GET pc_folder PARENT_PATH libraries)
  run(${CXX} -std=c++20 ${CONSUMER}/main.cpp ${flags} -Wl,-rpath,${libraries} -o ${FOLDER}/with_pkg_config)
  run_consumer(${FOLDER}/with_pkg_config)
  file(REMOVE ${FOLDER}/with_pkg_config)
endif()

# The completions are those of the program, where shells look for them.
foreach(shell IN ITEMS bash zsh fish)
  file(GLOB_RECURSE found ${prefix}/share/bash-completion/*meniscus ${prefix}/share/zsh/*_meniscus
    ${prefix}/share/fish/*meniscus.fish)
  list(FILTER found INCLUDE REGEX "/share/${shell}")
  execute_process(COMMAND ${prefix}/bin/meniscus completion ${shell} OUTPUT_VARIABLE printed)
  file(READ "${found}" installed)
  if(NOT installed STREQUAL printed)
    message(FATAL_ERROR "the completion of ${shell} is not that of the program")
  endif()
endforeach()

# The port for vcpkg is of this version.
file(READ ${SOURCE}/cmake/packaging/vcpkg/ports/meniscus/vcpkg.json port)
string(JSON port_version GET "${port}" version)
run(${prefix}/bin/meniscus --version)
if(NOT output MATCHES "meniscus ${port_version}\n")
  message(FATAL_ERROR "vcpkg.json is of version ${port_version}, but the program prints ${output}")
endif()

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

# The manual's tutorial on linking. It checks its own result, and draws.
if(NOT SANITIZE)
  file(REMOVE_RECURSE ${FOLDER}/tutorial)
  run(${CMAKE_COMMAND} -S ${SOURCE}/docs/manual/tutorials/cmake -B ${FOLDER}/tutorial -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_BUILD_TYPE=${BUILD_TYPE})
  run(${CMAKE_COMMAND} --build ${FOLDER}/tutorial)
  run(${CMAKE_COMMAND} -E chdir ${FOLDER}/tutorial ./drop)
  file(STRINGS ${FOLDER}/tutorial/drop.svg circles REGEX "<circle")
  list(LENGTH circles drawn)
  if(drawn LESS 1000)
    message(FATAL_ERROR "the tutorial draws ${drawn} particles")
  endif()
  file(REMOVE_RECURSE ${FOLDER}/tutorial)
endif()

# A sample that the source tree does not have can only come from the prefix.
file(COPY_FILE ${prefix}/share/meniscus/scenes/hydrostatic.json ${prefix}/share/meniscus/scenes/installed.json)
run(${prefix}/bin/meniscus check installed)
file(REMOVE_RECURSE ${prefix} ${FOLDER}/package)
