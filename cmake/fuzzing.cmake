# The targets for libFuzzer (tests/fuzz/targets), and the instrumentation of the sources that they test.
#
#   GVD_BUILD_FUZZERS  ON: build them. Needs clang++ and GVD_SANITIZE=address,undefined.
option(GVD_BUILD_FUZZERS "Build libFuzzer's targets for the readers" OFF)
if(GVD_BUILD_FUZZERS AND NOT (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND GVD_SANITIZE MATCHES "address"))
  message(FATAL_ERROR "libFuzzer comes with clang++ and finds little without the address sanitizer: configure with "
                      "-DCMAKE_CXX_COMPILER=clang++ -DGVD_SANITIZE=address,undefined, or set GVD_BUILD_FUZZERS=OFF")
endif()

# gvd_guide_fuzzers(SOURCES...): libFuzzer sees which branches of SOURCES an input takes. Only readers are instrumented, so that
# the other tests of the same build tree do not become slower.
function(gvd_guide_fuzzers)
  if(GVD_BUILD_FUZZERS)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -fsanitize=fuzzer-no-link)
  endif()
endfunction()
