# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# What `cmake --install` puts where: the public headers, the libraries with a CMake package and a pkg-config file, the
# program, its completions, the samples. Each belongs to one of the components library, development and program.

include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Meniscus)

install(DIRECTORY sdk/include/meniscus DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN *.h)
install(TARGETS meniscus_scene meniscus meniscus_fluid meniscus_cloth meniscus_collision meniscus_pbd
  EXPORT MeniscusTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
if(MENISCUS_BUILD_C)
  install(TARGETS meniscus_c EXPORT MeniscusTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
endif()
install(EXPORT MeniscusTargets NAMESPACE Meniscus:: DESTINATION ${package_folder} COMPONENT development)

configure_package_config_file(cmake/MeniscusConfig.cmake.in ${PROJECT_BINARY_DIR}/package/MeniscusConfig.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/MeniscusConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/MeniscusConfig.cmake ${PROJECT_BINARY_DIR}/package/MeniscusConfigVersion.cmake
  cmake/MeniscusBullet.cmake cmake/MeniscusFind.cmake DESTINATION ${package_folder} COMPONENT development)
include(MeniscusPkgConfig)
install(FILES ${PROJECT_BINARY_DIR}/meniscus.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

if(MENISCUS_BUILD_CLI)
  install(TARGETS meniscus_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  install(DIRECTORY samples/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/meniscus COMPONENT program)
  install(FILES samples/scene.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/meniscus COMPONENT program)
  include(MeniscusCompletions)
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
if(PROJECT_IS_TOP_LEVEL AND BUILD_SHARED_LIBS AND MENISCUS_BUILD_CLI)
  include(packaging/MeniscusPackage)
endif()
