# `cmake --install`: libraries, headers, commands, examples, and the packages that find_package(gvd) and pkg-config find.
# Each component but `licence` becomes a Debian package (package.cmake).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

file(STRINGS CITATION.cff release_date REGEX "^date-released:")
string(REGEX MATCH "[0-9]+-[0-9]+-[0-9]+" GVD_RELEASE_DATE "${release_date}")
set(GVD_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/gvd)

install(TARGETS gvd EXPORT gvd-targets COMPONENT dev)
install(DIRECTORY libgvd/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev FILES_MATCHING PATTERN *.hpp)

# The libraries that this configuration builds.
set(GVD_INSTALLED_PARTS "")
foreach(part segment lloyd remesh operations)
  if(TARGET gvd_${part})
    list(APPEND GVD_INSTALLED_PARTS ${part})
    install(TARGETS gvd_${part} EXPORT gvd-targets COMPONENT dev)
    install(DIRECTORY libgvd/${part}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev
            FILES_MATCHING PATTERN *.hpp)
  endif()
endforeach()
# Programs that run need the shared library only, so it is a component of its own.
install(TARGETS gvd_c EXPORT gvd-targets LIBRARY COMPONENT c NAMELINK_COMPONENT dev)
install(DIRECTORY libgvd/c/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev FILES_MATCHING PATTERN *.h)
install(EXPORT gvd-targets NAMESPACE gvd:: DESTINATION ${GVD_CMAKE_DIR} COMPONENT dev)
if(GVD_COMMANDS)
  install(TARGETS gvd_program COMPONENT commands)
  list(TRANSFORM GVD_COMMANDS PREPEND ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/ OUTPUT_VARIABLE GVD_COMMAND_LINKS)
  install(FILES ${GVD_COMMAND_LINKS} DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT commands)
endif()

# Separate, so that only users of the component `verify` need CGAL and accept its licence.
if(TARGET gvd_verify)
  list(APPEND GVD_INSTALLED_PARTS verify)
  install(TARGETS gvd_verify EXPORT gvd-verify-targets COMPONENT verify)
  install(DIRECTORY libgvd/verify/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT verify
          FILES_MATCHING PATTERN *.hpp)
  install(EXPORT gvd-verify-targets NAMESPACE gvd:: DESTINATION ${GVD_CMAKE_DIR} COMPONENT verify)
endif()

install(FILES LICENSE LICENSES.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)
# The workflow in cohort/ runs commands, and some of its files are programs.
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT dev PATTERN cohort EXCLUDE)
install(DIRECTORY examples/cohort DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT commands USE_SOURCE_PERMISSIONS
        PATTERN __pycache__ EXCLUDE)

configure_package_config_file(cmake/gvd-config.cmake.in ${PROJECT_BINARY_DIR}/gvd-config.cmake
  INSTALL_DESTINATION ${GVD_CMAKE_DIR})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gvd-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gvd-config.cmake ${PROJECT_BINARY_DIR}/gvd-config-version.cmake
  DESTINATION ${GVD_CMAKE_DIR} COMPONENT dev)

# gvd_install_pc(NAME DESCRIPTION REQUIRES LIBS CFLAGS): NAME.pc, which pkg-config reads.
file(RELATIVE_PATH GVD_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" GVD_PC_PREFIX ${GVD_PC_PREFIX})
function(gvd_install_pc name description requires libs cflags)
  configure_file(cmake/gvd.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endfunction()

# Users before what they use: static libraries are searched in the order of the command line.
set(GVD_PC_LIBS "")
set(GVD_PC_REQUIRES eigen3 fmt)
if(GVD_WITH_TBB)
  list(APPEND GVD_PC_REQUIRES tbb)
endif()
if(GVD_WITH_XML)
  list(APPEND GVD_PC_REQUIRES pugixml zlib)
endif()
foreach(part operations remesh segment lloyd)
  if(part IN_LIST GVD_INSTALLED_PARTS)
    string(APPEND GVD_PC_LIBS "-lgvd_${part} ")
  endif()
endforeach()
if(GVD_WITH_OPENMESH AND TARGET gvd_remesh)
  list(APPEND GVD_PC_REQUIRES openmesh)
endif()
list(JOIN GVD_PC_REQUIRES " " GVD_PC_REQUIRES)
gvd_install_pc(gvd "${PROJECT_DESCRIPTION}" "${GVD_PC_REQUIRES}" "${GVD_PC_LIBS}-lgvd" -std=c++20)
gvd_install_pc(gvd_c "${PROJECT_DESCRIPTION}, from C" "" -lgvd_c "")
