# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Flags common to all targets, and the helper that makes one library a folder.

include(GNUInstallDirs)

set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(MENISCUS_CCACHE ccache)
if(MENISCUS_CCACHE AND PROJECT_IS_TOP_LEVEL)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${MENISCUS_CCACHE})
  set(CMAKE_CUDA_COMPILER_LAUNCHER ${MENISCUS_CCACHE})
endif()

# What our own sources are compiled with. Those who link the libraries do not inherit it.
add_library(meniscus_flags INTERFACE)
target_compile_features(meniscus_flags INTERFACE cxx_std_20)
target_include_directories(meniscus_flags INTERFACE ${PROJECT_SOURCE_DIR})
# Equal bits on every processor: no fused multiply-add behind our back. Without errno, sqrtf is one instruction.
set(meniscus_host_flags -Wall -Wextra -Wshadow -ffp-contract=off -fno-math-errno)
target_compile_options(meniscus_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:${meniscus_host_flags}>)
# As a part of a project that names no build type.
target_compile_options(meniscus_flags INTERFACE $<$<CONFIG:>:-O3> $<$<CONFIG:>:-DNDEBUG>)
# For code that does not have to be fast: readers of text, and the tests' own code. It compiles in two thirds of the time
# of CMake's -O3. Results have the same bits.
set(meniscus_fast_build $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CONFIG:Release>>:-O1>)

if(MENISCUS_SANITIZE)
  target_compile_options(meniscus_flags INTERFACE
    $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=${MENISCUS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all>)
  target_link_options(meniscus_flags INTERFACE -fsanitize=${MENISCUS_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_compile_options(meniscus_flags INTERFACE
      $<$<COMPILE_LANGUAGE:CXX>:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/tests/sanitizers/ignored.txt>)
  endif()
endif()

option(MENISCUS_MERGE_SOURCES "Compile small sources eight at a time: a first build is faster, and one after an edit slower" OFF)

# meniscus_library(NAME [INTERNAL] [MERGED] SOURCES... [CUDA SOURCES...] [LINK TARGETS...]): CUDA sources count where CUDA
# is on. The library is shared with BUILD_SHARED_LIBS. An INTERNAL one is never installed, and always static. Sources of a
# MERGED one may be compiled together. Kernels stand alone, so that they are optimised alike everywhere.
function(meniscus_library name)
  cmake_parse_arguments(arg "INTERNAL;MERGED" "" "SOURCES;CUDA;LINK" ${ARGN})
  set(kind)
  if(arg_INTERNAL)
    set(kind STATIC)
  endif()
  add_library(${name} ${kind} ${arg_SOURCES})
  if(arg_MERGED AND MENISCUS_MERGE_SOURCES)
    set(kernels ${arg_SOURCES})
    list(FILTER kernels INCLUDE REGEX "_cpu\\.cpp$")
    set_source_files_properties(${kernels} ${arg_CUDA} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON)
  endif()
  # No definition of the library's own, which would compile shared objects a second time under ccache.
  set_target_properties(${name} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}
    DEFINE_SYMBOL "" INSTALL_RPATH "$ORIGIN")
  target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE $<BUILD_INTERFACE:meniscus_flags>)
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/sdk/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  if(MENISCUS_CUDA)
    target_sources(${name} PRIVATE ${arg_CUDA})
    # For those who link us without knowing of CUDA. nvcc finds its headers by itself.
    target_link_libraries(${name} PRIVATE $<LINK_ONLY:${meniscus_cudart}>)
  endif()
endfunction()
