# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Builds Meniscus as a part of a user's project, with FetchContent: WHOLE, without optimising, and the consumer with it;
# else one library, which takes seconds in place of minutes, of a project that names no build type.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)

set(folder ${FOLDER}/subproject)
set(options -DMENISCUS_SOURCE=${SOURCE} -DMENISCUS_CUDA=OFF -DMENISCUS_MERGE_SOURCES=ON)
if(WHOLE)
  set(BUILD_TYPE Debug)
  build_and_run_consumer(${folder}_whole ${options})
else()
  set(BUILD_TYPE "")
  configure_consumer(${folder} ${options} -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
  file(READ ${folder}/compile_commands.json commands)
  if(NOT commands MATCHES "-O3[^\n]*cpu_device.cpp")
    message(FATAL_ERROR "without a build type Meniscus is not optimised")
  endif()
  run(${CMAKE_COMMAND} --build ${folder} --parallel 2 --target meniscus_pbd)
endif()
