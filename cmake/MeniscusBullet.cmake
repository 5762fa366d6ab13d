# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Bullet's libraries as a target. CMake's own module finds paths alone, which would be those of the machine that built
# an installed package.

include(CMakeFindDependencyMacro)
find_dependency(Bullet MODULE)
if(BULLET_FOUND AND NOT TARGET Bullet::Dynamics)
  add_library(Bullet::Dynamics INTERFACE IMPORTED)
  set_target_properties(Bullet::Dynamics PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${BULLET_INCLUDE_DIRS}"
    INTERFACE_INCLUDE_DIRECTORIES "${BULLET_INCLUDE_DIRS}"
    INTERFACE_LINK_LIBRARIES "${BULLET_DYNAMICS_LIBRARY};${BULLET_COLLISION_LIBRARY};${BULLET_MATH_LIBRARY}")
endif()
