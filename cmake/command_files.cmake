# Man pages and completions of gvd and of its commands, as they themselves tell them: --help and --print-completion.
#
#   GVD_HELP2MAN  help2man; without it no man page is made
find_program(GVD_HELP2MAN help2man)
if(CMAKE_CROSSCOMPILING OR NOT GVD_COMMANDS)
  return()
endif()
if(NOT GVD_HELP2MAN)
  message(STATUS "Building without man pages: help2man is missing")
endif()

set(folder ${PROJECT_BINARY_DIR}/command_files)
file(MAKE_DIRECTORY ${folder})
set(all_files "")
foreach(command gvd ${GVD_COMMANDS})
  set(program ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${command})
  set(files ${folder}/${command} ${folder}/_${command} ${folder}/${command}.fish)
  set(make COMMAND ${program} --print-completion bash > ${folder}/${command}
           COMMAND ${program} --print-completion zsh > ${folder}/_${command}
           COMMAND ${program} --print-completion fish > ${folder}/${command}.fish)
  install(FILES ${folder}/${command} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT commands)
  install(FILES ${folder}/_${command} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT commands)
  install(FILES ${folder}/${command}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT commands)
  if(GVD_HELP2MAN)
    list(APPEND files ${folder}/${command}.1)
    list(APPEND make COMMAND ${PROJECT_SOURCE_DIR}/scripts/make_man_page.sh ${program} ${GVD_RELEASE_DATE}
                       gvd ${GVD_COMMANDS} > ${folder}/${command}.1)
    install(FILES ${folder}/${command}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT commands)
  endif()
  add_custom_command(OUTPUT ${files} ${make} DEPENDS gvd_program ${GVD_COMMAND_LINKS} ${PROJECT_SOURCE_DIR}/scripts/make_man_page.sh
    COMMENT "Writing the man page and the completions of ${command}" VERBATIM)
  list(APPEND all_files ${files})
endforeach()
add_custom_target(gvd_command_files ALL DEPENDS ${all_files})
