# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# What CPack puts into Debian packages: libmeniscus0, libmeniscus-dev and meniscus. cmake/packaging/make-deb makes them.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Meniscus authors <noreply@meniscus.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_COMPONENTS_ALL library development program)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
  ${PROJECT_BINARY_DIR}/pbd ${PROJECT_BINARY_DIR}/fluid ${PROJECT_BINARY_DIR}/cloth ${PROJECT_BINARY_DIR}/collision
  ${PROJECT_BINARY_DIR}/sdk)

set(same_library "libmeniscus0 (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libmeniscus0)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "Shared libraries.")
# ldconfig runs when the libraries come and go.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_GENERATE_SHLIBS_POLICY =)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmeniscus-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "${same_library}, libtbb-dev, libassimp-dev, zlib1g-dev, libbullet-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers, the CMake package and the pkg-config file.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME meniscus)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${same_library}")
# OpenGL with no screen is looked up at run time.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libegl1, libgl1-mesa-dri, fonts-dejavu-core")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "glmark2-data, ffmpeg")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "The command line program, its completions and the sample scenes.")

include(CPack)
