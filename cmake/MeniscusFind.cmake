# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Finds other packages. Those that are not here are collected, so that one message names all of Debian's packages.

# meniscus_find(NAME DEBIAN_PACKAGES [OPTION...]): find_package with these options.
macro(meniscus_find name packages)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    list(APPEND meniscus_missing ${name})
    string(APPEND meniscus_missing_packages " ${packages}")
  endif()
endmacro()

# meniscus_missing_text(TEXT): the message, or nothing.
function(meniscus_missing_text text)
  set(${text} "" PARENT_SCOPE)
  if(meniscus_missing)
    list(JOIN meniscus_missing ", " names)
    set(${text} "Meniscus needs ${names}. On Debian and Ubuntu: apt-get install${meniscus_missing_packages}" PARENT_SCOPE)
  endif()
endfunction()
