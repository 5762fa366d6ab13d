# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Decides whether Alembic files are written: MENISCUS_ALEMBIC is AUTO (where Alembic is found), ON or OFF in the cache, and
# true or false after this file. Where they are not, MENISCUS_NO_ALEMBIC_REASON says why. The target meniscus_alembic has
# the library.

set(MENISCUS_ALEMBIC AUTO CACHE STRING "Write Alembic files: AUTO, ON or OFF")
set_property(CACHE MENISCUS_ALEMBIC PROPERTY STRINGS AUTO ON OFF)
set(MENISCUS_NO_ALEMBIC_REASON "that was switched off when Meniscus was built")
if(MENISCUS_ALEMBIC)
  find_package(Alembic CONFIG QUIET)
  if(TARGET Alembic::Alembic)
    set(MENISCUS_ALEMBIC ON)
    add_library(meniscus_alembic INTERFACE)
    target_link_libraries(meniscus_alembic INTERFACE Alembic::Alembic)
  else()
    # Neither Debian 12 nor Ubuntu 24.04 has a package of it.
    set(MENISCUS_NO_ALEMBIC_REASON
      "Alembic was not found when Meniscus was built (https://github.com/alembic/alembic, or vcpkg's port alembic)")
    if(NOT MENISCUS_ALEMBIC STREQUAL AUTO)
      message(FATAL_ERROR "MENISCUS_ALEMBIC is ON, but Alembic's CMake package is not here; CMAKE_PREFIX_PATH takes its place")
    endif()
    set(MENISCUS_ALEMBIC OFF)
  endif()
endif()
if(MENISCUS_ALEMBIC)
  message(STATUS "Meniscus: with Alembic files")
else()
  message(STATUS "Meniscus: without Alembic files (${MENISCUS_NO_ALEMBIC_REASON})")
endif()
