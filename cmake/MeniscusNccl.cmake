# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Decides whether ranks can be GPUs: MENISCUS_NCCL is AUTO (where NCCL is found beside CUDA and MPI), ON or OFF in the cache,
# and true or false after this file. Where they cannot, MENISCUS_NO_NCCL_REASON says why. The target meniscus_nccl has the
# library.

set(MENISCUS_NCCL AUTO CACHE STRING "Share worlds among GPUs with NCCL: AUTO, ON or OFF")
set_property(CACHE MENISCUS_NCCL PROPERTY STRINGS AUTO ON OFF)
set(MENISCUS_NO_NCCL_REASON "that was switched off when Meniscus was built")
if(MENISCUS_NCCL)
  set(asked ${MENISCUS_NCCL})
  set(MENISCUS_NCCL OFF)
  if(NOT MENISCUS_CUDA)
    set(MENISCUS_NO_NCCL_REASON "it was built without CUDA")
  else()
    find_path(MENISCUS_NCCL_INCLUDE nccl.h HINTS ${CUDAToolkit_INCLUDE_DIRS})
    find_library(MENISCUS_NCCL_LIBRARY nccl HINTS ${CUDAToolkit_LIBRARY_DIR})
    if(MENISCUS_NCCL_INCLUDE AND MENISCUS_NCCL_LIBRARY)
      set(MENISCUS_NCCL ON)
      add_library(meniscus_nccl INTERFACE)
      target_include_directories(meniscus_nccl SYSTEM INTERFACE ${MENISCUS_NCCL_INCLUDE} ${CUDAToolkit_INCLUDE_DIRS})
      target_link_libraries(meniscus_nccl INTERFACE ${MENISCUS_NCCL_LIBRARY})
    else()
      set(MENISCUS_NO_NCCL_REASON "NCCL was not found when Meniscus was built (NVIDIA's package libnccl-dev)")
    endif()
  endif()
  if(NOT MENISCUS_NCCL AND NOT asked STREQUAL AUTO)
    message(FATAL_ERROR "MENISCUS_NCCL is ON, but ${MENISCUS_NO_NCCL_REASON}")
  endif()
endif()
if(MENISCUS_NCCL)
  message(STATUS "Meniscus: with NCCL")
else()
  message(STATUS "Meniscus: without NCCL (${MENISCUS_NO_NCCL_REASON})")
endif()
