# `cpack -G DEB` in the build folder makes packages of what is installed: rocking, and rocking-mpi where it was built.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # it packs what is built, and builds nothing

# Who is responsible for the package: by default who made the last change.
if(NOT DEFINED CACHE{ROCKING_PACKAGE_CONTACT})
  execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} log -1 "--format=%an <%ae>"
    OUTPUT_VARIABLE contact OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed OR contact STREQUAL "")
    set(contact "the authors of rocking")
  endif()
  set(ROCKING_PACKAGE_CONTACT "${contact}" CACHE STRING "Maintainer of the package, NAME <ADDRESS>")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rocking)
set(CPACK_PACKAGE_VENDOR "the authors of rocking")
set(CPACK_PACKAGE_CONTACT "${ROCKING_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

# The parts that are installed without a name are the package rocking.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL Unspecified)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME rocking)
set(CPACK_DEBIAN_UNSPECIFIED_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_UNSPECIFIED_DESCRIPTION "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_RECOMMENDS gnuplot-nox)
# To link to the static library.
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SUGGESTS "rocking-mpi, libssl-dev, libsqlite3-dev, libpugixml-dev")
if(TARGET rocking-mpi)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
  set(CPACK_DEBIAN_MPI_PACKAGE_NAME rocking-mpi)
  set(CPACK_DEBIAN_MPI_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_MPI_DESCRIPTION "Runs of rocking shared between the processes of mpirun")
  set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "rocking (= ${PROJECT_VERSION})")
endif()
include(CPack)
