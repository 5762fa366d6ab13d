# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# The program writes the completions of bash, zsh and fish at build time. One that is built for another machine cannot.

if(CMAKE_CROSSCOMPILING)
  return()
endif()
# meniscus_completion(SHELL FOLDER FILE): where the shell looks for the completions of other packages.
function(meniscus_completion shell folder file)
  set(output ${PROJECT_BINARY_DIR}/completions/${file})
  add_custom_command(OUTPUT ${output} VERBATIM
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/completions
    COMMAND sh -c "\"$0\" completion ${shell} > \"$1\"" $<TARGET_FILE:meniscus_program> ${output}
    DEPENDS meniscus_program)
  set_property(TARGET meniscus_completions APPEND PROPERTY SOURCES ${output})
  install(FILES ${output} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder} COMPONENT program)
endfunction()

add_custom_target(meniscus_completions ALL)
meniscus_completion(bash bash-completion/completions meniscus)
meniscus_completion(zsh zsh/site-functions _meniscus)
meniscus_completion(fish fish/vendor_completions.d meniscus.fish)
