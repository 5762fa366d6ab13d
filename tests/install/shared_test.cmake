# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Builds shared libraries beside the build folder, where the compiler cache has their objects, and tests their package.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)

set(shared ${BUILD}-shared)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${shared} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
  -DCMAKE_CXX_COMPILER=${CXX} -DMENISCUS_MERGE_SOURCES=${MERGE_SOURCES} -DBUILD_SHARED_LIBS=ON
  -DMENISCUS_CUDA=OFF -DMENISCUS_BUILD_TESTS=OFF)
run(${CMAKE_COMMAND} --build ${shared} --parallel 2)
foreach(library IN ITEMS sdk/libmeniscus pbd/libmeniscus_pbd)
  if(NOT EXISTS ${shared}/${library}.so.0)
    message(FATAL_ERROR "${library}.so.0 was not built")
  endif()
endforeach()

set(BUILD ${shared})
string(APPEND FOLDER /shared)
file(MAKE_DIRECTORY ${FOLDER})
include(${CMAKE_CURRENT_LIST_DIR}/package_test.cmake)
