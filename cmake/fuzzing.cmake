# The targets for libFuzzer (tests/fuzz/targets), and the instrumentation of the sources that they test.
#
#   GVD_BUILD_FUZZERS  ON: build them. Needs clang++ and GVD_SANITIZE=address,undefined.
option(GVD_BUILD_FUZZERS "Build libFuzzer's targets for the readers" OFF)
if(GVD_BUILD_FUZZERS AND NOT (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND GVD_SANITIZE MATCHES "address"))
  message(FATAL_ERROR "libFuzzer comes with clang++ and finds little without the address sanitizer: configure with "
                      "-DCMAKE_CXX_COMPILER=clang++ -DGVD_SANITIZE=address,undefined, or set GVD_BUILD_FUZZERS=OFF")
endif()

# gvd_guide_fuzzers(TARGET SOURCES...): libFuzzer sees which branches of these SOURCES of TARGET an input takes. Only readers are
# instrumented, so that the other tests of the same build tree do not become slower. They become an object library, which has the
# options of TARGET and its own, because sources with options of their own would not be united. Call this when TARGET links to all
# that it needs.
function(gvd_guide_fuzzers target)
  if(NOT GVD_BUILD_FUZZERS)
    return()
  endif()
  set(guided ${target}_guided)
  get_target_property(libraries ${target} LINK_LIBRARIES)
  add_library(${guided} OBJECT ${ARGN})
  target_compile_features(${guided} PRIVATE cxx_std_20)
  target_include_directories(${guided} PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
  target_compile_definitions(${guided} PRIVATE $<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>)
  target_link_libraries(${guided} PRIVATE ${libraries})
  target_compile_options(${guided} PRIVATE -fsanitize=fuzzer-no-link,alignment)
  gvd_unite(${guided})

  get_target_property(other_sources ${target} SOURCES)
  list(REMOVE_ITEM other_sources ${ARGN})
  set_target_properties(${target} PROPERTIES SOURCES "${other_sources}")
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${guided}>)
endfunction()
