# What others get: one library, rocking::rocking, made of the objects of all rooms, with its headers and its files for
# find_package and pkg-config. None of our compiler flags goes with it.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(pugixml REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(Threads REQUIRED)

foreach(room ${rooms})
  list(APPEND room_objects $<TARGET_OBJECTS:rocking_${room}>)
  list(APPEND room_headers $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include/${room}>)
endforeach()
list(APPEND room_headers $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include/door>)
if(ROCKING_PAGES)
  list(APPEND room_objects
    $<TARGET_OBJECTS:rocking_pages> $<TARGET_OBJECTS:rocking_page> $<TARGET_OBJECTS:rocking_analysis>)
  list(APPEND room_headers $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include/pages>)
endif()
add_library(rocking_library ${room_objects})  # static or shared, by BUILD_SHARED_LIBS
add_library(rocking::rocking ALIAS rocking_library)
set_target_properties(rocking_library PROPERTIES
  OUTPUT_NAME rocking EXPORT_NAME rocking LINKER_LANGUAGE CXX
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_compile_features(rocking_library INTERFACE cxx_std_20)
target_include_directories(rocking_library INTERFACE ${room_headers} $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(rocking_library PRIVATE SQLite::SQLite3 Threads::Threads
  $<BUILD_INTERFACE:rocking_crypto> $<BUILD_INTERFACE:rocking_pugixml>
  $<INSTALL_INTERFACE:OpenSSL::Crypto> $<INSTALL_INTERFACE:pugixml::pugixml>)
if(ROCKING_SANITIZE)
  target_link_options(rocking_library PUBLIC -fsanitize=${ROCKING_SANITIZE})
endif()

if(NOT ROCKING_INSTALL)
  return()
endif()
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/rocking)
install(TARGETS rocking_library EXPORT rocking-targets)
install(EXPORT rocking-targets NAMESPACE rocking:: DESTINATION ${package_folder})
configure_package_config_file(package/rocking-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/rocking-config.cmake
  INSTALL_DESTINATION ${package_folder})
# 0.x: a minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/rocking-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/rocking-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/rocking-config-version.cmake
  DESTINATION ${package_folder})
install(CODE "set(SOURCE \"${CMAKE_CURRENT_SOURCE_DIR}\")
set(PAGES ${ROCKING_PAGES})
set(DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")
include(\"${CMAKE_CURRENT_SOURCE_DIR}/package/install_headers.cmake\")")

# With a static library, whoever links needs what it links to.
set(pkg_config_requires Requires)
set(pkg_config_libs Libs.private)
if(BUILD_SHARED_LIBS)
  set(pkg_config_requires Requires.private)
endif()
configure_file(package/rocking.pc.in ${CMAKE_CURRENT_BINARY_DIR}/rocking.pc.in @ONLY)
# The prefix is known when it is installed, not before.
install(CODE "file(READ \"${CMAKE_CURRENT_BINARY_DIR}/rocking.pc.in\" text)
string(REGEX REPLACE \"^prefix=[^\\n]*\" \"prefix=\${CMAKE_INSTALL_PREFIX}\" text \"\${text}\")
file(WRITE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/pkgconfig/rocking.pc\" \"\${text}\")")

# Licences of what is compiled into the library and the program, or into the pages that it writes, as Debian has them.
foreach(package libjs-dygraphs librandom123-dev nlohmann-json3-dev libeigen3-dev libboost1.81-dev libboost-dev libfmt-dev
    libcli11-dev pybind11-dev libssl-dev libsqlite3-dev libpugixml-dev libzip-dev libopenmpi-dev)
  if(EXISTS /usr/share/doc/${package}/copyright)
    install(FILES /usr/share/doc/${package}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR}/licences RENAME ${package})
  endif()
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/reports/schemas/ DESTINATION ${CMAKE_INSTALL_DATADIR}/rocking/schemas
  FILES_MATCHING PATTERN "*.schema.json")
