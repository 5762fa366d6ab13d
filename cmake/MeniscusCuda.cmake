# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Decides MENISCUS_CUDA. It is on where an nvcc of version 12 or later is found and compiles with this host compiler.

include(CheckLanguage)

# meniscus_find_nvcc(REASON): enables CUDA, or says in REASON why it cannot be used.
macro(meniscus_find_nvcc reason)
  if(NOT CMAKE_CUDA_COMPILER AND NOT DEFINED ENV{CUDACXX} AND EXISTS /usr/local/cuda/bin/nvcc)
    set(ENV{CUDACXX} /usr/local/cuda/bin/nvcc)
  endif()
  if(NOT CMAKE_CUDA_ARCHITECTURES)
    # The GPU at hand; without one, code that any driver can compile for a GPU from Turing on.
    file(GLOB gpus /dev/nvidia[0-9]*)
    if(gpus)
      set(CMAKE_CUDA_ARCHITECTURES native)
    else()
      set(CMAKE_CUDA_ARCHITECTURES 75-virtual)
    endif()
  endif()
  check_language(CUDA)
  if(NOT CMAKE_CUDA_COMPILER)
    set(${reason} "no nvcc that works with this host compiler")
  else()
    enable_language(CUDA)
    if(CMAKE_CUDA_COMPILER_VERSION VERSION_LESS 12)
      set(${reason} "nvcc ${CMAKE_CUDA_COMPILER_VERSION} is older than 12")
    else()
      meniscus_try_nvcc(${reason})
    endif()
  endif()
endmacro()

# An nvcc may compile a bare kernel, and yet fail on the host compiler's C++20 headers.
function(meniscus_try_nvcc reason)
  if(NOT DEFINED MENISCUS_NVCC_WORKS)
    message(CHECK_START "Meniscus: compiling C++20 with nvcc")
    try_compile(MENISCUS_NVCC_WORKS
      SOURCE_FROM_CONTENT probe.cu [[
#include <cub/device/device_scan.cuh>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>
__global__ void probe(int* out) { *out = 1; }
int main() {
  std::vector<int> host(1);
  probe<<<1, 1>>>(std::span<int>(host).data());
}
]]
      COMPILE_DEFINITIONS -std=c++20
      OUTPUT_VARIABLE output)
    message(CHECK_PASS "${MENISCUS_NVCC_WORKS}")
    if(NOT MENISCUS_NVCC_WORKS)
      message(VERBOSE "${output}")
    endif()
  endif()
  if(NOT MENISCUS_NVCC_WORKS)
    set(${reason} "nvcc ${CMAKE_CUDA_COMPILER_VERSION} does not compile C++20 with this host compiler" PARENT_SCOPE)
  endif()
endfunction()

set(cuda_reason "")
if(NOT DEFINED MENISCUS_CUDA OR MENISCUS_CUDA)
  meniscus_find_nvcc(cuda_reason)
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
  find_package(CUDAToolkit REQUIRED)
  # One runtime for all libraries, and for programs with kernels: it keeps errors, and knows the kernels linked with it.
  if(BUILD_SHARED_LIBS)
    set(CMAKE_CUDA_RUNTIME_LIBRARY Shared)
    set(meniscus_cudart CUDA::cudart)
  else()
    set(meniscus_cudart CUDA::cudart_static)
  endif()
  # C++ sources know of CUDA only where they say so. The others are compiled as without it, so a build for both takes their
  # objects from the compiler's cache.
  target_compile_definitions(meniscus_flags INTERFACE $<$<COMPILE_LANGUAGE:CUDA>:MENISCUS_HAS_CUDA=1>)
  set(meniscus_cuda_definitions MENISCUS_HAS_CUDA=1)
  string(REPLACE ";" "," host_flags "-Wall;-ffp-contract=off;-fno-math-errno")
  # The standard by hand: CMake before 3.26 does not know that nvcc has C++20.
  target_compile_options(meniscus_flags INTERFACE
    $<$<COMPILE_LANGUAGE:CUDA>:-std=c++20 -Xcompiler=${host_flags}>)
endif()
