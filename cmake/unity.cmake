# Unity builds: several sources in one translation unit, so that the headers of other projects are parsed once for all of
# them (docs/notes/build-time.md says what this gains). No two sources of a target may use one name for different things.
#
#   GVD_UNITY  OFF: a translation unit for each source. Missing includes become errors, and one changed source builds quickly;
#              TESTS: the same, but for the tests.
set(GVD_UNITY ON CACHE STRING "Compile several sources as one translation unit: ON, OFF, or TESTS for those of the tests alone")
set_property(CACHE GVD_UNITY PROPERTY STRINGS ON OFF TESTS)

# Number of sources in a unit. Larger units leave processors idle at the end, and g++ inlines otherwise in them. Where nothing is
# timed, they save more: for tests, which are many, and under sanitizers.
set(GVD_UNITY_BATCH 12)
set(GVD_UNITY_BATCH_UNTIMED 24)

# gvd_unite([FOR_TESTS] TARGETS...): compiles the sources of TARGETS in units, if GVD_UNITY is set.
function(gvd_unite)
  cmake_parse_arguments(arg "FOR_TESTS" "" "" ${ARGN})
  if(GVD_UNITY STREQUAL "TESTS" AND NOT arg_FOR_TESTS)
    return()
  endif()
  if(GVD_UNITY)
    set(batch ${GVD_UNITY_BATCH})
    if(arg_FOR_TESTS OR GVD_SANITIZE)
      set(batch ${GVD_UNITY_BATCH_UNTIMED})
    endif()
    set_target_properties(${arg_UNPARSED_ARGUMENTS} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
  endif()
endfunction()
