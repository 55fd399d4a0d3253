# `cpack -G DEB` in the build folder makes one package of what is installed.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # it packs what is built, and builds nothing
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rocking)
set(CPACK_PACKAGE_VENDOR "the authors of rocking")
set(CPACK_PACKAGE_CONTACT "the authors of rocking <rocking@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox)
# To link to the static library.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libssl-dev, libsqlite3-dev, libjs-dygraphs")
include(CPack)
