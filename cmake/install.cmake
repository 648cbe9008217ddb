# `cmake --install`: libraries, headers, commands, and the package that find_package(gvd) finds.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(GVD_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/gvd)

# The parts that this configuration builds.
set(GVD_INSTALLED_PARTS "")
foreach(part segment lloyd remesh verify)
  if(TARGET gvd_${part})
    list(APPEND GVD_INSTALLED_PARTS ${part})
    set_target_properties(gvd_${part} PROPERTIES EXPORT_NAME ${part})
    install(TARGETS gvd_${part} EXPORT gvd-targets)
  endif()
  if(EXISTS ${PROJECT_SOURCE_DIR}/apps/${part}/include AND TARGET gvd_${part})
    install(DIRECTORY apps/${part}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.hpp)
  endif()
  if(TARGET gvd-${part})
    install(TARGETS gvd-${part})
  endif()
endforeach()

install(TARGETS gvd EXPORT gvd-targets)
install(DIRECTORY libgvd/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.hpp)
install(EXPORT gvd-targets NAMESPACE gvd:: DESTINATION ${GVD_CMAKE_DIR})
install(FILES LICENSE LICENSES.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/gvd-config.cmake.in ${PROJECT_BINARY_DIR}/gvd-config.cmake
  INSTALL_DESTINATION ${GVD_CMAKE_DIR})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gvd-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gvd-config.cmake ${PROJECT_BINARY_DIR}/gvd-config-version.cmake
  DESTINATION ${GVD_CMAKE_DIR})
