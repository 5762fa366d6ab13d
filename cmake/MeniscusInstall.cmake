# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# What `cmake --install` puts where: the public headers, the libraries with a CMake package, the program, the samples.

include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Meniscus)

install(DIRECTORY sdk/include/meniscus DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h)
install(TARGETS meniscus_scene meniscus meniscus_fluid meniscus_cloth meniscus_collision meniscus_pbd
  EXPORT MeniscusTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(MENISCUS_BUILD_C)
  install(TARGETS meniscus_c EXPORT MeniscusTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
install(EXPORT MeniscusTargets NAMESPACE Meniscus:: DESTINATION ${package_folder})

configure_package_config_file(cmake/MeniscusConfig.cmake.in ${PROJECT_BINARY_DIR}/MeniscusConfig.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/MeniscusConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/MeniscusConfig.cmake ${PROJECT_BINARY_DIR}/MeniscusConfigVersion.cmake
  cmake/MeniscusBullet.cmake DESTINATION ${package_folder})

if(MENISCUS_BUILD_CLI)
  install(TARGETS meniscus_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY samples/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/meniscus)
  install(FILES samples/scene.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/meniscus)
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
