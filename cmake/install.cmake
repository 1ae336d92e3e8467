# Files of `cmake --install`: other projects find the engine by find_package(Trilith) as Trilith::trilith.
# Users write #include <trilith/base/error.hpp>; between themselves the headers write "base/error.hpp".
include(CMakePackageConfigHelpers)

set(TRILITH_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Trilith)
install(TARGETS trilith EXPORT TrilithTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${CMAKE_INSTALL_INCLUDEDIR}/trilith)
install(EXPORT TrilithTargets NAMESPACE Trilith:: DESTINATION ${TRILITH_CONFIG_DIR})
install(DIRECTORY engine/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trilith FILES_MATCHING PATTERN "*.hpp")

configure_package_config_file(cmake/TrilithConfig.cmake.in ${PROJECT_BINARY_DIR}/TrilithConfig.cmake
  INSTALL_DESTINATION ${TRILITH_CONFIG_DIR} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/TrilithConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/TrilithConfig.cmake ${PROJECT_BINARY_DIR}/TrilithConfigVersion.cmake
  DESTINATION ${TRILITH_CONFIG_DIR})
# Pages as they lie in the tree, so that their links hold. Debian reads the licence from the file `copyright`.
set(TRILITH_DOCS ${CMAKE_INSTALL_DATAROOTDIR}/doc/trilith)
install(FILES LICENSE DESTINATION ${TRILITH_DOCS} RENAME copyright)
install(FILES README.md CONTRIBUTING.md LICENSE DESTINATION ${TRILITH_DOCS})
install(DIRECTORY docs DESTINATION ${TRILITH_DOCS} FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.png")
# The same pages as a site, where `./dev docs` has built it.
install(DIRECTORY build/docs/html DESTINATION ${TRILITH_DOCS} OPTIONAL)
