# Unity builds: several sources in one translation unit, so that the headers of other projects are parsed once for all of
# them (docs/notes/build-time.md has what that gains). No two sources of a target may use one name for different things.
#
#   GVD_UNITY  OFF: a translation unit for each source. A missing include shows, and one changed source builds quickly.
option(GVD_UNITY "Compile several sources as one translation unit" ON)

# Sources in a unit. More of them gain little, and leave processors idle at the end.
set(GVD_UNITY_BATCH 12)

# gvd_unite(TARGETS...): compiles the sources of TARGETS in units, where GVD_UNITY is ON.
function(gvd_unite)
  if(GVD_UNITY)
    set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${GVD_UNITY_BATCH})
  endif()
endfunction()
