# The program, its completion for bash, and manual pages of its help.
include(GNUInstallDirs)
install(TARGETS rocking)
if(TARGET rocking-mpi)
  install(TARGETS rocking-mpi COMPONENT mpi)  # a package of its own, so that nobody else needs MPI
endif()

set(help_folder ${CMAKE_CURRENT_BINARY_DIR}/help)
file(MAKE_DIRECTORY ${help_folder}/man1)
add_custom_command(OUTPUT ${help_folder}/rocking
  COMMAND rocking completion bash > ${help_folder}/rocking DEPENDS rocking VERBATIM)
list(APPEND help_files ${help_folder}/rocking)
find_program(ROCKING_PYTHON_INTERPRETER python3)
if(ROCKING_PYTHON_INTERPRETER)
  add_custom_command(OUTPUT ${help_folder}/man1/rocking.1
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${help_folder}/man1
    COMMAND ${CMAKE_COMMAND} -E make_directory ${help_folder}/man1
    COMMAND ${ROCKING_PYTHON_INTERPRETER} ${CMAKE_CURRENT_SOURCE_DIR}/manual_pages $<TARGET_FILE:rocking>
      ${help_folder}/man1
    DEPENDS rocking manual_pages help_text.py VERBATIM)
  list(APPEND help_files ${help_folder}/man1/rocking.1)
else()
  message(STATUS "manual pages skipped: python3 was not found")
endif()
add_custom_target(rocking_help ALL DEPENDS ${help_files})
# All that `cmake --install` needs, without the tests.
add_custom_target(installation DEPENDS rocking rocking_library rocking_help)
if(TARGET rocking-mpi)
  add_dependencies(installation rocking-mpi)
endif()
install(FILES ${help_folder}/rocking DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(DIRECTORY ${help_folder}/man1/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
