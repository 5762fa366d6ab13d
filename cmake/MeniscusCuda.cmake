# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Decides MENISCUS_CUDA. It is on where an nvcc of version 12 or later is found and compiles with this host compiler.

include(CheckLanguage)

set(cuda_reason "")
if(NOT DEFINED MENISCUS_CUDA OR MENISCUS_CUDA)
  if(NOT CMAKE_CUDA_COMPILER AND NOT DEFINED ENV{CUDACXX} AND EXISTS /usr/local/cuda/bin/nvcc)
    set(CMAKE_CUDA_COMPILER /usr/local/cuda/bin/nvcc)
  endif()
  if(NOT CMAKE_CUDA_ARCHITECTURES)
    # The GPU at hand; without one, code that any driver can compile for a GPU from Turing on.
    if(EXISTS /dev/nvidia0)
      set(CMAKE_CUDA_ARCHITECTURES native)
    else()
      set(CMAKE_CUDA_ARCHITECTURES 75-virtual)
    endif()
  endif()
  check_language(CUDA)  # compiles a program with nvcc and this host compiler
  if(NOT CMAKE_CUDA_COMPILER)
    set(cuda_reason "no nvcc that works with this host compiler")
  else()
    enable_language(CUDA)
    if(CMAKE_CUDA_COMPILER_VERSION VERSION_LESS 12)
      set(cuda_reason "nvcc ${CMAKE_CUDA_COMPILER_VERSION} is older than 12")
    endif()
  endif()
else()
  set(cuda_reason "switched off")
endif()

if(cuda_reason AND MENISCUS_CUDA)
  message(FATAL_ERROR "MENISCUS_CUDA is asked for, but: ${cuda_reason}")
elseif(cuda_reason)
  set(cuda_default OFF)
  message(STATUS "Meniscus: CPU alone (${cuda_reason})")
else()
  set(cuda_default ON)
  message(STATUS "Meniscus: CUDA ${CMAKE_CUDA_COMPILER_VERSION} for ${CMAKE_CUDA_ARCHITECTURES}")
endif()
option(MENISCUS_CUDA "Build the CUDA device" ${cuda_default})

if(MENISCUS_CUDA)
  set(CMAKE_CUDA_STANDARD 20)
  set(CMAKE_CUDA_STANDARD_REQUIRED ON)
  set(CMAKE_CUDA_EXTENSIONS OFF)
  string(REPLACE ";" "," host_flags "-Wall;-ffp-contract=off;-fno-math-errno")
  target_compile_options(meniscus_flags INTERFACE
    $<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=${host_flags} -Wno-deprecated-gpu-targets>)
endif()
