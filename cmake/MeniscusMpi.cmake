# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Decides whether the program runs on several ranks: MENISCUS_MPI is AUTO (where MPI is found), ON or OFF in the cache, and
# true or false after this file. Where it does not, MENISCUS_NO_MPI_REASON says why. The target MPI::MPI_CXX has the
# library.

set(MENISCUS_MPI AUTO CACHE STRING "Run on several ranks with MPI: AUTO, ON or OFF")
set_property(CACHE MENISCUS_MPI PROPERTY STRINGS AUTO ON OFF)
set(MENISCUS_NO_MPI_REASON "that was switched off when Meniscus was built")
if(MENISCUS_MPI)
  set(MPI_CXX_SKIP_MPICXX TRUE)  # the bindings of MPI 2 for C++
  find_package(MPI QUIET COMPONENTS CXX)
  if(MPI_CXX_FOUND)
    set(MENISCUS_MPI ON)
  else()
    set(MENISCUS_NO_MPI_REASON "MPI was not found when Meniscus was built (Debian's package libopenmpi-dev)")
    if(NOT MENISCUS_MPI STREQUAL AUTO)
      message(FATAL_ERROR "MENISCUS_MPI is ON, but MPI is not here (Debian: libopenmpi-dev)")
    endif()
    set(MENISCUS_MPI OFF)
  endif()
endif()
if(MENISCUS_MPI)
  message(STATUS "Meniscus: with MPI")
else()
  message(STATUS "Meniscus: without MPI (${MENISCUS_NO_MPI_REASON})")
endif()
