# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# The README's program is the one that the package test compiles and runs, but for the comments at its top.
file(READ ${README} readme)
file(READ ${PROGRAM} program)
string(REGEX REPLACE "^(//[^\n]*\n)+" "" program "${program}")
string(FIND "${readme}" "```cpp\n${program}```\n" at)
if(at EQUAL -1)
  message(FATAL_ERROR "README.md does not hold ${PROGRAM} as it is")
endif()
