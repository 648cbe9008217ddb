# Debian packages, by cpack: `make package` leaves them in BUILD/packages.
#
#   GVD_PACKAGE_CONTACT  the packages' Maintainer. The default is no address that receives mail: this project has none
set(GVD_PACKAGE_CONTACT "the gvd developers <developers@gvd.invalid>" CACHE STRING "Maintainer of the packages")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT ${GVD_PACKAGE_CONTACT})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # it would come before the title of each package
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packaging/debian/finish_packages.cmake)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)  # a package for each component
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(GVD_DEBIAN_VERSION ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
set(CPACK_COMPONENTS_ALL "")

# The changelog has the date of the release, so that the same sources give the same packages.
execute_process(COMMAND date -R -u -d ${GVD_RELEASE_DATE} OUTPUT_VARIABLE GVD_RELEASE_DATE_RFC
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
configure_file(packaging/debian/changelog.in ${PROJECT_BINARY_DIR}/debian/changelog.Debian @ONLY)

set(GVD_FREE_OF_GPL "The sources are under the Expat licence, and no part of CGAL is compiled in.")
set(GVD_BOUND_BY_GPL "The sources are under the Expat licence. Parts of CGAL are compiled in, so that these binaries as a whole may
 be passed on only under the GNU General Public License, version 3 or later.")

# gvd_add_package(COMPONENT NAME SECTION DEPENDS COMMENT DESCRIPTION): what install() gives to COMPONENT becomes the package
# NAME. DEPENDS comes on top of what dpkg-shlibdeps finds; COMMENT opens the copyright file; the first line of DESCRIPTION
# is the title.
macro(gvd_add_package component name section depends comment description)
  string(TOUPPER ${component} upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}")
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
  gvd_write_copyright(${PROJECT_BINARY_DIR}/debian/${component}/copyright "${comment}")
  install(FILES ${PROJECT_BINARY_DIR}/debian/${component}/copyright ${PROJECT_BINARY_DIR}/debian/changelog.Debian
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES packaging/debian/lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME ${name}
          COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()

function(gvd_write_copyright file comment)
  set(cgal "")
  if(comment STREQUAL GVD_BOUND_BY_GPL)
    set(cgal "
Files: CGAL
Copyright: 1995-2022 the CGAL Project and its contributors
License: GPL-3+ and LGPL-3+
Comment: Each file is under one of the two.

License: GPL-3+
 On Debian systems, the text is in /usr/share/common-licenses/GPL-3.

License: LGPL-3+
 On Debian systems, the text is in /usr/share/common-licenses/LGPL-3.
")
  endif()
  configure_file(packaging/debian/copyright.in ${file} @ONLY)
endfunction()

if(GVD_COMMANDS)
  set(comment ${GVD_FREE_OF_GPL})
  if(TARGET gvd_verify)
    set(comment ${GVD_BOUND_BY_GPL})
  endif()
  gvd_add_package(commands gvd science "" "${comment}"
"geodesic Voronoi diagrams on triangle meshes
Commands that compute the Voronoi diagram of points on a triangle mesh, by
exact distances along the surface. gvd segment labels the faces with the
nearest point, gvd lloyd spreads points evenly, gvd remesh builds a coarse
mesh of the same topology, and gvd distance measures distances and paths.")
  # For the workflow in examples/cohort.
  set(CPACK_DEBIAN_COMMANDS_PACKAGE_SUGGESTS "python3-gvd, snakemake")
endif()

get_target_property(soname gvd_c SOVERSION)
gvd_add_package(c libgvd-c${soname} libs "" "${GVD_FREE_OF_GPL}"
"geodesic Voronoi diagrams on triangle meshes (C interface)
The shared library for programs in C and in languages that call C functions:
exact distances and shortest paths on triangle meshes, Voronoi diagrams,
segmentation, relaxation and remeshing.")
# What dpkg-shlibdeps reads for programs on this library, and the trigger that lintian asks for.
file(WRITE ${PROJECT_BINARY_DIR}/debian/c/shlibs "libgvd_c ${soname} libgvd-c${soname} (>= ${PROJECT_VERSION})\n")
file(WRITE ${PROJECT_BINARY_DIR}/debian/c/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_C_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/c/shlibs ${PROJECT_BINARY_DIR}/debian/c/triggers)

# A static library fits the interface of one major version of {fmt} only, whose names begin with it.
math(EXPR fmt_next "${fmt_VERSION_MAJOR} + 1")
gvd_add_package(dev libgvd-dev libdevel
"libeigen3-dev (>= 3.4), libfmt-dev (>= ${fmt_VERSION_MAJOR}), libfmt-dev (<< ${fmt_next}), libopenmesh-dev, \
libtbb-dev (>= 2021), libpugixml-dev (>= 1.11), zlib1g-dev, libgvd-c${soname} (= ${GVD_DEBIAN_VERSION})" "${GVD_FREE_OF_GPL}"
"geodesic Voronoi diagrams on triangle meshes (library)
The C++20 library of the commands in gvd: exact distances and shortest paths
on triangle meshes, Voronoi diagrams with their bisectors and branch points,
segmentation, relaxation and remeshing. Static libraries, the headers of C++
and of C, packages for CMake and pkg-config, and examples.")
if(TARGET gvd_verify)
  gvd_add_package(verify libgvd-verify-dev libdevel "libgvd-dev (= ${GVD_DEBIAN_VERSION}), libcgal-dev (>= 5.5)"
"${GVD_BOUND_BY_GPL}"
"check of geodesic Voronoi diagrams against CGAL (library)
The part of libgvd that measures diagrams against the exact shortest paths of
CGAL, which are under the GPL. It is separate so that libgvd-dev is not.")
endif()
if(TARGET gvd_python)
  gvd_add_package(python python3-gvd python
"python3 (>= 3.9), python3-numpy, libgvd-c${soname} (= ${GVD_DEBIAN_VERSION})" "${GVD_FREE_OF_GPL}"
"geodesic Voronoi diagrams on triangle meshes (Python package)
NumPy arrays in, NumPy arrays out: exact distances and shortest paths on
triangle meshes, Voronoi diagrams with their bisectors and branch points,
segmentation, relaxation and remeshing.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/debian/python/postinst
      ${PROJECT_SOURCE_DIR}/packaging/debian/python/prerm)
endif()
include(CPack)
