# `cpack` makes one Debian package of program, Lua module, Python module, C++ package, manual page, completion, examples and pages.
# It is made from a build of `all` (./dev package), in one piece. Debian's lua5.4 looks for modules in /usr/lib/lua/5.4.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME trilith)
set(CPACK_PACKAGE_VENDOR "Trilith contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION "Masonry, bridges on bearings, arches and columns are simulated from rest through an
earthquake to collapse. Models are Lua scripts, run by the program trilith or by lua5.4;
results are one HDF5 file. The engine is a C++ library as well, found by find_package(Trilith).")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_SET_DESTDIR OFF)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(TRILITH_MAINTAINER "Trilith contributors <trilith@localhost>" CACHE STRING "whom the Debian package names; for one that is handed on, your own")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${TRILITH_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS lua5.4)
# Packages needed to compile against the C++ package, for films, and for the Python module.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
  "g++, cmake, pkg-config, libeigen3-dev, libfmt-dev, libhdf5-dev, libcairo2-dev, zlib1g-dev, bash-completion, ffmpeg, python3-h5py, python3-pandas, python3-matplotlib")
include(CPack)
