# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT

# run(COMMAND...): runs a command, and fails with its output.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# configure_consumer(FOLDER OPTION...)
function(configure_consumer folder)
  set(flags)
  if(SANITIZE)
    set(flags -DCMAKE_CXX_FLAGS=-fsanitize=${SANITIZE})
  endif()
  run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${folder} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
    -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} ${flags} ${ARGN})
endfunction()

# build_and_run_consumer(FOLDER OPTION...): configures, builds and runs the consumer, whose water must have moved.
function(build_and_run_consumer folder)
  configure_consumer(${folder} ${ARGN})
  run(${CMAKE_COMMAND} --build ${folder} --parallel 2)
  run_consumer(${folder}/consumer)
endfunction()

# run_consumer(PROGRAM)
function(run_consumer program)
  run(${program})
  if(NOT output MATCHES "3000 particles on .*: after 2.0 s the front is at x = (-?[0-9.]+) m" OR CMAKE_MATCH_1 LESS 1)
    message(FATAL_ERROR "the consumer printed:\n${output}")
  endif()
endfunction()
