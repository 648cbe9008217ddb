# `cmake --install`: libraries, headers, commands, and the package that find_package(gvd) finds.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(GVD_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/gvd)

install(TARGETS gvd EXPORT gvd-targets)
install(DIRECTORY libgvd/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.hpp)

# The libraries that this configuration builds.
set(GVD_INSTALLED_PARTS "")
foreach(part segment lloyd remesh)
  if(TARGET gvd_${part})
    list(APPEND GVD_INSTALLED_PARTS ${part})
    install(TARGETS gvd_${part} EXPORT gvd-targets)
    install(DIRECTORY libgvd/${part}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.hpp)
  endif()
  if(TARGET gvd-${part})
    install(TARGETS gvd-${part})
  endif()
endforeach()
install(TARGETS gvd_c EXPORT gvd-targets)
install(DIRECTORY libgvd/c/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h)
install(EXPORT gvd-targets NAMESPACE gvd:: DESTINATION ${GVD_CMAKE_DIR})

# Separate, so that only users of the component `verify` need CGAL and accept its licence.
if(TARGET gvd_verify)
  list(APPEND GVD_INSTALLED_PARTS verify)
  install(TARGETS gvd_verify EXPORT gvd-verify-targets)
  install(DIRECTORY libgvd/verify/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.hpp)
  install(EXPORT gvd-verify-targets NAMESPACE gvd:: DESTINATION ${GVD_CMAKE_DIR})
endif()

install(FILES LICENSE LICENSES.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/gvd-config.cmake.in ${PROJECT_BINARY_DIR}/gvd-config.cmake
  INSTALL_DESTINATION ${GVD_CMAKE_DIR})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gvd-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gvd-config.cmake ${PROJECT_BINARY_DIR}/gvd-config-version.cmake
  DESTINATION ${GVD_CMAKE_DIR})
