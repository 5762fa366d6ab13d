# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Decides whether OpenVDB files are written: MENISCUS_OPENVDB is AUTO (where OpenVDB is found), ON or OFF in the cache, and
# true or false after this file. Where they are not, MENISCUS_NO_OPENVDB_REASON says why. The target meniscus_openvdb has
# the library.

set(MENISCUS_OPENVDB AUTO CACHE STRING "Write OpenVDB files: AUTO, ON or OFF")
set_property(CACHE MENISCUS_OPENVDB PROPERTY STRINGS AUTO ON OFF)
set(MENISCUS_NO_OPENVDB_REASON "that was switched off when Meniscus was built")
if(MENISCUS_OPENVDB)
  find_path(OPENVDB_INCLUDE_DIR openvdb/openvdb.h)
  find_library(OPENVDB_LIBRARY openvdb)
  # Its headers include those of both, and Debian's package does not ask for Boost.
  find_path(IMATH_INCLUDE_DIR half.h PATH_SUFFIXES Imath)
  find_library(IMATH_LIBRARY NAMES Imath Imath-3_1 Imath-3_2)
  find_path(BOOST_INCLUDE_DIR boost/numeric/conversion/conversion_traits.hpp)
  if(OPENVDB_INCLUDE_DIR AND OPENVDB_LIBRARY AND IMATH_INCLUDE_DIR AND IMATH_LIBRARY AND
     BOOST_INCLUDE_DIR)
    set(MENISCUS_OPENVDB ON)
    find_package(TBB REQUIRED)
    add_library(meniscus_openvdb INTERFACE)
    target_include_directories(meniscus_openvdb SYSTEM INTERFACE ${OPENVDB_INCLUDE_DIR} ${IMATH_INCLUDE_DIR}
      ${BOOST_INCLUDE_DIR})
    target_link_libraries(meniscus_openvdb INTERFACE ${OPENVDB_LIBRARY} ${IMATH_LIBRARY} TBB::tbb)
  else()
    set(MENISCUS_NO_OPENVDB_REASON
      "OpenVDB was not found when Meniscus was built (Debian's packages libopenvdb-dev and libboost-dev)")
    if(NOT MENISCUS_OPENVDB STREQUAL AUTO)
      message(FATAL_ERROR "MENISCUS_OPENVDB is ON, but OpenVDB is not here (Debian: libopenvdb-dev libboost-dev)")
    endif()
    set(MENISCUS_OPENVDB OFF)
  endif()
endif()
if(MENISCUS_OPENVDB)
  message(STATUS "Meniscus: with OpenVDB files")
else()
  message(STATUS "Meniscus: without OpenVDB files (${MENISCUS_NO_OPENVDB_REASON})")
endif()
