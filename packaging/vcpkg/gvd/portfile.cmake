# Port for vcpkg:  vcpkg install gvd --overlay-ports=packaging/vcpkg
#
# Tried: vcpkg.json parsed; this file run by CMake with functions of the same names that only check what they are given. Not built
# with vcpkg.
# To publish: replace SOURCE_PATH by vcpkg_from_github with the release.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS
  FEATURES
    tools GVD_BUILD_APPS
    verify GVD_WITH_CGAL_GPL
)
# The page of --view needs npm, which vcpkg does not have.
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${FEATURE_OPTIONS} -DGVD_BUILD_TESTS=OFF -DGVD_WITH_VIEWER=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME gvd CONFIG_PATH lib/cmake/gvd)
vcpkg_fixup_pkgconfig()
if("tools" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES gvd gvd-segment gvd-lloyd gvd-remesh gvd-distance AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/LICENSES.md")
