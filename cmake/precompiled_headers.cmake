# Headers of other projects, parsed once for many sources (docs/notes/build-time.md has what that gains).
#
#   GVD_PRECOMPILE_HEADERS  OFF: each source parses what it includes, which shows an include that is missing.
#
# All users of one precompiled header are compiled with the same options as it; position-independent code would part
# libraries from programs, so it is off by default there.
if(BUILD_SHARED_LIBS OR CMAKE_POSITION_INDEPENDENT_CODE)
  set(gvd_precompile_default OFF)
else()
  set(gvd_precompile_default ON)
endif()
option(GVD_PRECOMPILE_HEADERS "Parse the headers of other projects once" ${gvd_precompile_default})

# What most sources include, directly or through a header of ours.
set(GVD_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers> <optional>
  <ostream> <set> <span> <sstream> <string> <string_view> <tuple> <utility> <vector>
  <Eigen/Core> <Eigen/Geometry> <fmt/format.h>)

# gvd_add_precompiled_headers(NAME HEADERS... LIBRARIES...): precompiles HEADERS with the options of LIBRARIES.
function(gvd_add_precompiled_headers name)
  if(NOT GVD_PRECOMPILE_HEADERS)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;LIBRARIES")
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled_headers.cpp)
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
  # So that compiler caches can share the result between build trees.
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:Clang,AppleClang>:SHELL:-Xclang -fno-pch-timestamp>)
endfunction()

# gvd_use_precompiled_headers(TARGET NAME): the sources of TARGET begin with what NAME has precompiled.
function(gvd_use_precompiled_headers target name)
  if(GVD_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
