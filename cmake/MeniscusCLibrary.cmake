# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# The shared library for C. It holds all of Meniscus and shows nothing but the functions of meniscus_c.h. Before version
# 1.0 a minor version may change them, so that the name of the library and its symbols has both numbers.

set(meniscus_c_sources bodies cloth defs export hooks host measures member member_list particles queries recording scene setters state status world)
list(TRANSFORM meniscus_c_sources REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/sdk/c/\\1.cpp")
configure_file(${PROJECT_SOURCE_DIR}/sdk/c/meniscus_c.map.in ${PROJECT_BINARY_DIR}/meniscus_c.map @ONLY)

add_library(meniscus_c SHARED ${meniscus_c_sources})
add_library(Meniscus::meniscus_c ALIAS meniscus_c)
target_link_libraries(meniscus_c PRIVATE meniscus_flags meniscus_io)
target_include_directories(meniscus_c PUBLIC
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/sdk/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_options(meniscus_c PRIVATE ${meniscus_fast_build})
target_link_options(meniscus_c PRIVATE
  LINKER:--version-script=${PROJECT_BINARY_DIR}/meniscus_c.map LINKER:--exclude-libs,ALL LINKER:--no-undefined)
set_target_properties(meniscus_c PROPERTIES
  CXX_VISIBILITY_PRESET hidden
  VISIBILITY_INLINES_HIDDEN ON
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  LINK_DEPENDS ${PROJECT_BINARY_DIR}/meniscus_c.map)
if(MENISCUS_SANITIZE)  # the sanitizers' own symbols come from the program
  get_target_property(options meniscus_c LINK_OPTIONS)
  list(REMOVE_ITEM options LINKER:--no-undefined)
  set_target_properties(meniscus_c PROPERTIES LINK_OPTIONS "${options}")
endif()
