# Target `packages`: in packages/ of the build folder a Debian package and a wheel, each with the program and the Python
# module, and rocking-mpi where it was built. They are for the system and the Python of the build: its release is in the name.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # cpack packs what is built, and builds nothing

# Who is responsible for the package: by default who made the last change.
if(NOT DEFINED CACHE{ROCKING_PACKAGE_CONTACT})
  execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} log -1 "--format=%an <%ae>"
    OUTPUT_VARIABLE contact OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed OR contact STREQUAL "")
    set(contact "the authors of rocking")
  endif()
  set(ROCKING_PACKAGE_CONTACT "${contact}" CACHE STRING "Maintainer of the package, NAME <ADDRESS>")
endif()
cmake_host_system_information(RESULT system QUERY DISTRIB_INFO)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rocking)
set(CPACK_PACKAGE_VENDOR "the authors of rocking")
set(CPACK_PACKAGE_CONTACT "${ROCKING_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${system_ID}${system_VERSION_ID})  # such as debian12
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

# The parts that are installed without a name, and the Python module, are the package rocking.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL Unspecified)
set(CPACK_COMPONENT_UNSPECIFIED_GROUP rocking)
set(CPACK_DEBIAN_ROCKING_PACKAGE_NAME rocking)
set(CPACK_DEBIAN_ROCKING_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ROCKING_DESCRIPTION "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_ROCKING_PACKAGE_RECOMMENDS gnuplot-nox)
# For sheets as PDF; to link to the static library.
set(CPACK_DEBIAN_ROCKING_PACKAGE_SUGGESTS "weasyprint, rocking-mpi, libssl-dev, libsqlite3-dev, libpugixml-dev")
set(scripts ${PROJECT_BINARY_DIR}/lib/package)
if(ROCKING_ARCHITECTURE MATCHES "v3")
  list(APPEND CPACK_DEBIAN_ROCKING_PACKAGE_CONTROL_EXTRA ${scripts}/preinst)
  file(WRITE ${scripts}/preinst [[#!/bin/sh
set -e
grep -qw avx2 /proc/cpuinfo || {
  echo "rocking: this package needs a processor with AVX2; on others build it there, as its README.md says" >&2
  exit 1
}
]])
endif()
if(TARGET rocking_python AND ROCKING_PYTHON_EXECUTABLE MATCHES "^/usr/bin/")
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_COMPONENT_PYTHON_GROUP rocking)
  string(REGEX REPLACE "^3\\." "" minor ${ROCKING_PYTHON_VERSION})
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_ROCKING_PACKAGE_DEPENDS
    "python3 (>= ${ROCKING_PYTHON_VERSION}), python3 (<< 3.${next}), python3-numpy")
  # So that removing the package leaves no compiled files.
  list(APPEND CPACK_DEBIAN_ROCKING_PACKAGE_CONTROL_EXTRA ${scripts}/postinst ${scripts}/prerm)
  file(WRITE ${scripts}/postinst "#!/bin/sh\nset -e\npy3compile -p rocking\n")
  file(WRITE ${scripts}/prerm "#!/bin/sh\nset -e\npy3clean -p rocking\n")
endif()
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
if(TARGET rocking-mpi)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
  set(CPACK_DEBIAN_MPI_PACKAGE_NAME rocking-mpi)
  set(CPACK_DEBIAN_MPI_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_MPI_DESCRIPTION "Runs of rocking shared between the processes of mpirun")
  set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "rocking (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
endif()
include(CPack)

set(folder ${PROJECT_BINARY_DIR}/packages)
add_custom_target(packages
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder}
  COMMAND ${CMAKE_CPACK_COMMAND} -G DEB -B ${folder}
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder}/_CPack_Packages)
add_dependencies(packages installation)
if(ROCKING_WASM_COMPILER AND ROCKING_WASM_LINKER AND ROCKING_WASM_LIBRARY)
  add_dependencies(packages live)  # lib/live
endif()
if(TARGET rocking_python)
  add_dependencies(packages rocking_python)
  add_custom_command(TARGET packages POST_BUILD COMMAND ${CMAKE_COMMAND} -E env ROCKING_BUILD_FOLDER=${PROJECT_BINARY_DIR}
    ${ROCKING_PYTHON_EXECUTABLE} -m pip -q wheel --no-build-isolation --no-deps --no-index --disable-pip-version-check
    -w ${folder} ${PROJECT_SOURCE_DIR})
endif()
