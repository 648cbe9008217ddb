# Finds CGAL, and says what to do if it is missing.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
set(gvd_saved_log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)  # QUIET alone does not silence CGAL's status lines
find_package(CGAL 5.5 QUIET)
set(CMAKE_MESSAGE_LOG_LEVEL "${gvd_saved_log_level}")
if(NOT CGAL_FOUND)
  message(FATAL_ERROR "CGAL 5.5 or later is missing: install libcgal-dev, or configure with -DGVD_WITH_CGAL_GPL=OFF")
endif()
