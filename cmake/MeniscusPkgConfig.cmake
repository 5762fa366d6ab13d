# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Writes meniscus.pc. With shared libraries, what they use themselves is private to them.

set(private_libs -lmeniscus_fluid -lmeniscus_cloth -lmeniscus_collision -lmeniscus_pbd)
if(MENISCUS_CUDA)
  list(APPEND private_libs "-L${CUDAToolkit_LIBRARY_DIR}")
  if(BUILD_SHARED_LIBS)
    list(APPEND private_libs -lcudart)
  else()
    list(APPEND private_libs -lcudart_static -ldl -lrt)
  endif()
endif()
list(JOIN private_libs " " private_libs)
if(BUILD_SHARED_LIBS)
  set(MENISCUS_PC_REQUIRES "Requires.private: tbb, assimp, bullet")
  set(MENISCUS_PC_LIBS "Libs: -L\${libdir} -lmeniscus_scene -lmeniscus\nLibs.private: ${private_libs} -pthread")
else()
  set(MENISCUS_PC_REQUIRES "Requires: tbb, assimp, bullet")
  set(MENISCUS_PC_LIBS "Libs: -L\${libdir} -lmeniscus_scene -lmeniscus ${private_libs} -pthread")
endif()
file(RELATIVE_PATH MENISCUS_PC_PREFIX
  ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/packaging/meniscus.pc.in ${PROJECT_BINARY_DIR}/meniscus.pc @ONLY)
