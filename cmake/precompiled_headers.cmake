# Headers of other projects, parsed once for many sources (docs/notes/build-time.md has what that gains).
#
#   GVD_PRECOMPILE_HEADERS  OFF: each source parses what it includes, which shows an include that is missing;
#                           TESTS: the same, but for the tests.
#
# All users of one precompiled header are compiled with the same options as it; position-independent code would part
# libraries from programs, so it is off by default there.
if(BUILD_SHARED_LIBS OR CMAKE_POSITION_INDEPENDENT_CODE)
  set(gvd_precompile_default OFF)
else()
  set(gvd_precompile_default ON)
endif()
set(GVD_PRECOMPILE_HEADERS ${gvd_precompile_default} CACHE STRING
    "Parse the headers of other projects once: ON, OFF, or TESTS for those of the tests alone")
set_property(CACHE GVD_PRECOMPILE_HEADERS PROPERTY STRINGS ON OFF TESTS)

# What most sources include, directly or through a header of ours.
set(GVD_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers> <optional>
  <ostream> <set> <span> <sstream> <string> <string_view> <tuple> <utility> <vector>
  <Eigen/Core> <Eigen/Geometry> <fmt/format.h>)

# gvd_add_precompiled_headers(NAME [FOR_TESTS] HEADERS... LIBRARIES...): precompiles HEADERS with the options of LIBRARIES.
function(gvd_add_precompiled_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "FOR_TESTS" "" "HEADERS;LIBRARIES")
  if(NOT GVD_PRECOMPILE_HEADERS OR (GVD_PRECOMPILE_HEADERS STREQUAL "TESTS" AND NOT arg_FOR_TESTS))
    return()
  endif()
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled_headers.cpp)
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
  # So that compiler caches can share the result between build trees.
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:Clang,AppleClang>:SHELL:-Xclang -fno-pch-timestamp>)
endfunction()

# gvd_use_precompiled_headers(TARGET NAME): the sources of TARGET begin with what NAME has precompiled, if it has.
function(gvd_use_precompiled_headers target name)
  if(TARGET ${name})
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
