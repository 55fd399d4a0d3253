# Sets source_revision: that of the checkout, with `-dirty` where it was changed; `unknown` outside a checkout.
find_package(Git QUIET)
set(source_revision "unknown")
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${PROJECT_SOURCE_DIR} describe --always --dirty --abbrev=12
                  OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(source_revision ${described})
  endif()
endif()
