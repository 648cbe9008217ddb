# Man pages and completions of the commands, as the commands themselves tell them: --help and --print-completion.
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
foreach(command IN LISTS GVD_COMMANDS)
  set(files ${folder}/${command} ${folder}/_${command} ${folder}/${command}.fish)
  set(make COMMAND ${command} --print-completion bash > ${folder}/${command}
           COMMAND ${command} --print-completion zsh > ${folder}/_${command}
           COMMAND ${command} --print-completion fish > ${folder}/${command}.fish)
  install(FILES ${folder}/${command} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT commands)
  install(FILES ${folder}/_${command} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT commands)
  install(FILES ${folder}/${command}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT commands)
  if(GVD_HELP2MAN)
    list(APPEND files ${folder}/${command}.1)
    list(APPEND make COMMAND ${PROJECT_SOURCE_DIR}/scripts/make_man_page.sh $<TARGET_FILE:${command}> ${GVD_RELEASE_DATE}
                       ${GVD_COMMANDS} > ${folder}/${command}.1)
    install(FILES ${folder}/${command}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT commands)
  endif()
  add_custom_command(OUTPUT ${files} ${make} DEPENDS ${command} ${PROJECT_SOURCE_DIR}/scripts/make_man_page.sh
    COMMENT "Writing the man page and the completions of ${command}" VERBATIM)
  list(APPEND all_files ${files})
endforeach()
add_custom_target(gvd_command_files ALL DEPENDS ${all_files})
